// SPDX-License-Identifier: MIT
#include "engine/jobs/distances/matrix.hpp"

#include <algorithm>
#include <charconv>
#include <functional>

#include "engine/checks/matrix_view.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/jobs/distances/bounded_matrix.hpp"
#include "engine/output/posix_file.hpp"
#include "engine/report/json.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/search/many_searches.hpp"
#include "engine/search/parallel_rows.hpp"
#include "engine/search/rows.hpp"
#include "engine/surface/face_weight.hpp"

namespace geodrome {

namespace {

/// What smooth distances of points within faces differ more from flat ones than those of vertices do, at most: of most
/// rows the flat ones are read at vertices only. It was 1.4 times on a torus.
constexpr double beside_vertices = 2;

/// Above this size a matrix is computed only with consent.
constexpr std::uint64_t consent_bytes = 4'000'000'000;

std::string fixed(double value, int decimals) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr};
}

std::string size_text(std::uint64_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (value >= 1e9) return fixed(value / 1e9, 2) + " GB";
  return value >= 1e6 ? fixed(value / 1e6, 1) + " MB" : fixed(value / 1e3, 1) + " kB";
}

std::string time_text(double seconds) {
  if (seconds < 1) return "under a second";
  if (seconds < 120) return "about " + fixed(seconds, 0) + " s";
  return "about " + (seconds < 7200 ? fixed(seconds / 60, 0) + " min" : fixed(seconds / 3600, 1) + " h");
}

/// `planned`: the rows may take less time, since the solver is going to be asked to prepare them together.
void tell_size(const MatrixFile::Spec& spec, std::uint64_t bytes, std::uint64_t missing, double row_seconds,
               bool planned, unsigned threads, Observer& observer) {
  const double seconds = row_seconds * static_cast<double>(missing) / threads;
  observer.log(LogLevel::info, "matrix: " + std::to_string(spec.rows) + " x " + std::to_string(spec.columns) + " " +
                                   (spec.scalar == ScalarType::float64 ? "float64" : "float32") + ", " +
                                   size_text(bytes) + "; " + std::to_string(missing) +
                                   (missing == 1 ? " row" : " rows") + " to compute, " + time_text(seconds) + " on " +
                                   std::to_string(threads) + (threads == 1 ? " thread" : " threads") +
                                   (planned && seconds >= 1 ? " if each is searched by itself" : ""));
}

void tell_unlocked(const MatrixFile& file, const MatrixFile::Spec& spec, Observer& observer) {
  if (file.is_locked()) return;
  const std::string partial = spec.out.string() + ".partial";
  observer.log(LogLevel::warning,
               partial + " cannot be locked on this file system: meanwhile " + partial + "-lock keeps other runs away");
}

void tell_overwritten(const MatrixFile::Spec& spec, Observer& observer) {
  observer.log(LogLevel::warning, spec.out.string() +
                                      ".partial, which an earlier run left, is overwritten; otherwise " +
                                      observer.words(remedies::go_on()));
}

void tell_unfinished(const MatrixFile& file, const MatrixFile::Spec& spec, Observer& observer) {
  observer.log(LogLevel::info, spec.out.string() + ".partial holds " + std::to_string(file.rows_done()) + " of " +
                                   std::to_string(spec.rows) + " rows; " + observer.words(remedies::go_on()));
}

/// Smooth distances differ from flat ones, of which the invariants hold, by the largest change at most; what rows of an
/// earlier run were changed by is not known.
Invariants check_invariants(const DistanceJob& job, const PreparedSolver& solver, const SurfaceMesh& mesh,
                            const MatrixFile& file, std::span<const NamedPoint> sources, const TargetList& targets,
                            const MatrixResult& made) {
  const auto read = [&](std::uint64_t row) { return file.read(row); };
  return check_invariants(
      sources, targets.named(), read,
      {.factor = solver.plugin.factor,
       .one_surface = job.query == ProjectionRule::project && !(made.smooth && made.resumed_rows > 0),
       .bounded =
           job.query != ProjectionRule::printed && (targets.bounded() || solver.provides(Provides::never_shorter)),
       .smallest_weight = smallest_weight(mesh),
       .change = made.smooth ? beside_vertices * made.smooth->largest_change : 0,
       .float32 = job.scalar == ScalarType::float32,
       .radius = job.max_distance,
       .seed = job.settings.seed});
}

/// Reads the whole matrix once more, as it stands on disk, resumed rows included.
ReachCounts count_reaches(const DistanceJob& job, const SourceSurfaces& surfaces, const MatrixFile& file,
                          std::span<const NamedPoint> sources) {
  const SurfaceMesh& mesh = *surfaces.reconstruction();
  const std::vector<Index> of_source = components_of(mesh, sources),
                           of_target = components_of(mesh, surfaces.targets().named());
  // An insertion leaves the components as they are, but beside it a target's closest point may change to another one.
  const std::vector<Index> all = vertex_components(mesh);
  const bool may_change =
      surfaces.rule() != ProjectionRule::project && std::ranges::adjacent_find(all, std::not_equal_to{}) != all.end();
  ReachCounts counts;
  const bool limited = std::isfinite(job.max_distance);
  for (std::uint64_t i = 0; i < sources.size(); ++i) {
    if (!may_change) {
      count_reach(file.read(i), of_source[i], of_target, limited, counts);
      continue;
    }
    const SourceSurface on = surfaces.of(sources[i]);
    count_reach(file.read(i), components_of(*on.mesh, {&on.source, 1})[0], components_of(*on.mesh, on.targets->named()),
                limited, counts);
  }
  return counts;
}

/// The intervals that the searches of the rows certify, if the solver states lower bounds: a place for each row.
class Certificates {
 public:
  Certificates(const PreparedSolver& solver, std::uint64_t rows) : solver_(solver) {
    if (StatedBounds(solver.plugin)) of_row_.resize(rows);
  }

  /// Thread-safe.
  void hear(std::uint64_t i, const SurfaceMesh& mesh, const ShortestPathMap& map) {
    if (!of_row_.empty()) of_row_[i] = *audit_intervals(solver_, mesh, map);
  }

  std::optional<IntervalFigures> figures() const {
    if (of_row_.empty()) return std::nullopt;
    IntervalFigures sum;
    for (std::uint64_t i = 0; i < of_row_.size(); ++i) sum.add(of_row_[i], i);
    return sum;
  }

 private:
  const PreparedSolver& solver_;
  std::vector<IntervalFigures> of_row_;
};

/// A file of bounds must not be taken for one of distances when a run goes on.
MatrixFile::Spec spec_of_bounds(MatrixFile::Spec spec, const std::filesystem::path& file) {
  spec.out = file;
  Json fingerprint = Json::parse(spec.fingerprint);
  fingerprint["holds"] = "lower bounds";
  spec.fingerprint = fingerprint.dump();
  return spec;
}

std::uint64_t bytes_of(const MatrixFile::Spec& spec, const MatrixFile::Spec& bounds) {
  return MatrixFile::bytes(spec) + (bounds.out.empty() ? 0 : MatrixFile::bytes(bounds));
}

void demand_consent(const DistanceJob& job, const MatrixFile::Spec& spec, const MatrixResult& result, bool planned,
                    Observer& observer) {
  if (result.bytes <= consent_bytes || job.yes) return;
  tell_size(spec, result.bytes, spec.rows, result.first_row_seconds, planned, thread_count(job.settings), observer);
  throw RefusedError(job.matrix.string() + " would take " + size_text(result.bytes), remedies::consent());
}

/// Refused while another run writes it.
BoundedMatrix open_matrix(const MatrixFile::Spec& spec, const MatrixFile::Spec& bounds, bool resume,
                          Observer& observer) {
  const bool overwrites = !resume && file_exists(spec.out.string() + ".partial");
  BoundedMatrix sink(spec, bounds, resume);
  if (overwrites) tell_overwritten(spec, observer);
  tell_unlocked(sink.matrix(), spec, observer);
  if (sink.bounds()) tell_unlocked(*sink.bounds(), bounds, observer);
  return sink;
}

/// Makes the rows that the sink has not, by what the solver prepares for all of them if there is a plan.
void make_rows(const DistanceJob& job, const PreparedSolver& solver, const std::optional<RowPlan>& plan,
               RowMaker& maker, RowSink& sink, const MatrixFile::Spec& spec, Observer& observer, MatrixResult& result) {
  const unsigned threads = thread_count(job.settings);
  const RowSet all = RowSet::all(spec.rows);
  const std::size_t missing = missing_rows(all, sink).size();
  tell_size(spec, result.bytes, missing, result.first_row_seconds, plan.has_value(), threads, observer);
  const Stopwatch stopwatch;
  PlannedSolver by{solver, {}};
  if (plan && missing > 0) {
    StageContext context(ShortestPathSolver::stage, observer, threads, job.settings.seed);
    by = prepare_plan(solver, *plan, context);
    result.plan = by.record;
  }
  StageContext context("distances", observer, threads, job.settings.seed);
  compute_rows(all, by.solver, maker, sink, threads, context);
  result.seconds = stopwatch.seconds() + result.first_row_seconds;
  result.counters = maker.counters();
  result.insertions = maker.insertions();
  result.smooth = maker.smooth();
}

/// What the rows of the file show.
void check_rows(const DistanceJob& job, const PreparedSolver& solver, const SourceSurfaces& surfaces,
                const MatrixFile& file, std::span<const NamedPoint> sources, MatrixResult& result) {
  result.reach = count_reaches(job, surfaces, file, sources);
  result.invariants =
      check_invariants(job, solver, *surfaces.reconstruction(), file, sources, surfaces.targets(), result);
}

}  // namespace

MatrixResult compute_matrix(const DistanceJob& job, const PreparedSolver& solver, const SourceSurfaces& surfaces,
                            std::span<const NamedPoint> sources, const std::string& fingerprint, Observer& observer) {
  const MatrixFile::Spec spec{job.matrix, sources.size(), surfaces.targets().size(), job.scalar, fingerprint};
  const MatrixFile::Spec bounds = job.bounds.empty() ? MatrixFile::Spec{} : spec_of_bounds(spec, job.bounds);
  MatrixResult result{.rows = spec.rows, .columns = spec.columns, .bytes = bytes_of(spec, bounds)};
  Certificates certificates(solver, spec.rows);
  RowAudit audit(solver, surfaces, sources, searched_radius(solver, job.max_distance), job.audit_share);
  const auto watch = [&](std::uint64_t i, const SourceSurface& on, const ShortestPathMap& map,
                         std::span<const double> flat) {
    audit.hear(i, on, cross_boundary(solver.plugin.info, [&] { return map.vertices(); }), flat);
    certificates.hear(i, *on.mesh, map);
  };
  RowMaker maker(solver, surfaces, sources, job.max_distance, job.settings.seed, observer,
                 {!job.bounds.empty(), watch, [&](std::uint64_t i) { return audit.looks_at(i); }});
  const std::optional<RowPlan> plan = plan_rows(solver, surfaces.rule(), sources, job.max_distance);

  const Stopwatch first;
  std::vector<double> row(maker.columns());
  maker.make(*make_search(solver), 0, row);
  result.first_row_seconds = first.seconds();
  demand_consent(job, spec, result, plan.has_value(), observer);
  BoundedMatrix sink = open_matrix(spec, bounds, job.resume, observer);
  const MatrixFile& file = sink.matrix();
  result.resumed_rows = file.rows_done();
  std::vector<std::vector<double>> rows;  // as they stand on disk, or flat
  try {
    if (!sink.has(0)) sink.write(0, row);
    make_rows(job, solver, plan, maker, sink, spec, observer, result);
    result.certified = certificates.figures();
    check_rows(job, solver, surfaces, file, sources, result);
    if (solver.smooth)
      rows = audit.heard_rows();
    else
      for (const std::size_t i : audit.sources()) rows.push_back(file.read(i));
    sink.finish();
  } catch (...) {
    tell_unfinished(file, spec, observer);
    throw;
  }
  StageContext context("audit", observer, 1, job.settings.seed);
  const double rounding = job.scalar == ScalarType::float32 && !solver.smooth ? 0x1p-24 : 0;
  result.audit = audit.judge(rows, rounding, job.settings.seed, context);
  return result;
}

}  // namespace geodrome
