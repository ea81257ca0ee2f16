// SPDX-License-Identifier: MIT
#include "geodrome/engine/session.hpp"

#include <algorithm>
#include <cmath>

#include "engine/checks/distance_audit.hpp"
#include "engine/checks/path_audit.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/jobs/check.hpp"
#include "engine/jobs/pairs/distances.hpp"
#include "engine/jobs/session_state.hpp"
#include "engine/report/provenance.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/search/named_points.hpp"
#include "engine/search/parallel_rows.hpp"
#include "engine/search/projection_rule.hpp"
#include "engine/search/rows.hpp"

namespace geodrome {

struct Session::Impl : SessionState {
  /// `source`: a file or an Input.
  template <class Source>
  Impl(Source&& source, RunSettings settings, Observer& observer, Provides demands)
      : SessionState(std::move(settings), observer, demands) {
    begin(std::forward<Source>(source));
    throw_if_refused(start, observer);
    tell_sample(start, observer);
  }

  /// The points of a list; the observer is told of those off the surface.
  std::vector<NamedPoint> points(const Selection& selection) const {
    std::vector<NamedPoint> points = resolve(selection, start.input(), start.surface());
    tell_off_surface(start.input(), start.surface(), {{selection, points}}, observer);
    return points;
  }

  /// Fills the rows of `wanted` that the sink does not have.
  void make_rows(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, RowSink& sink,
                 const DistanceOptions& options, const RowSet& wanted, RowExtras extras);

  /// Calls `use` with the surface of the path that the rule gives, the solver prepared on it, and a context.
  template <class Use>
  void on_path(const NamedPoint& from, const NamedPoint& to, ProjectionRule rule, Use&& use);
};

namespace {

void check_end(const NamedPoint& end, const PlacedSurface& surface, const std::string& what) {
  demand_on_part(end, surface, what + ": ");
  if (end.start != 0) throw OptionError(what + " has no start distance of its own");
  if (end.place.state == Place::State::dropped) throw OptionError(what + ": row " + end.label + " was dropped");
}

void check_starts(std::span<const NamedPoint> sources) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (const double start = sources[i].start; !(start >= 0 && start <= largest_number))
      throw OptionError("sources[" + std::to_string(i) + "]: a start distance is a number from 0 to 1e100, not " +
                        std::to_string(start));
}

/// The first place where two lists differ; their length if they do nowhere.
template <class Differs>
std::size_t first_that(Differs&& differs, std::span<const Distance> a, std::span<const Distance> b) {
  std::size_t j = 0;
  while (j < a.size() && !differs(a[j], b[j])) ++j;
  return j;
}

void check_rows(const RowSet& rows, std::size_t sources) {
  if (rows.size() == 0) return;
  if (const std::uint64_t last = rows[rows.size() - 1]; last >= sources)
    throw OptionError("row " + std::to_string(last) + " does not exist",
                      "there is one for each source, " + std::to_string(sources) + ", counted from 0");
}

}  // namespace

template <class Use>
void Session::Impl::on_path(const NamedPoint& from, const NamedPoint& to, ProjectionRule rule, Use&& use) {
  check_path_rule(rule);
  check_end(from, start.surface(), "the start of the path"), check_end(to, start.surface(), "the end of the path");
  check_rule(rule, start.opened, {&from, 1});
  demand(plugin.info, Provides::paths);
  const SourceSurface on = SourceSurfaces(rule, start.opened, {to}).of(from);
  check_provides(plugin.info, rule, {&on.source, 1}, on.targets->named(), infinity);
  StageContext searching = context(ShortestPathSolver::stage, 1);
  if (on.mesh == start.surface().mesh) return use(prepared(), on, searching);
  use(prepare_solver(plugin, on.mesh, host, settings, observer), on, searching);
}

void Session::Impl::make_rows(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, RowSink& sink,
                              const DistanceOptions& options, const RowSet& wanted, RowExtras extras) {
  check_limit(options.max_distance);
  check_starts(sources);
  check_rule(options.rule, start.opened, sources);
  const SourceSurfaces surfaces(options.rule, start.opened, {targets.begin(), targets.end()});
  check_provides(plugin.info, options.rule, sources, targets, options.max_distance);
  const PreparedSolver& solver = prepared();
  RowMaker maker(solver, surfaces, sources, options.max_distance, settings.seed, observer, std::move(extras));
  const unsigned threads = thread_count(settings);
  StageContext rows = context("distances", threads);
  const std::optional<RowPlan> plan = plan_rows(solver, options.rule, sources, options.max_distance);
  const bool needed = plan && !missing_rows(wanted, sink).empty();
  compute_rows(wanted, needed ? planned(*plan) : solver, maker, sink, threads, rows);
}

Observer& silent_observer() noexcept {
  static Observer observer;
  return observer;
}

Session::Session(const std::filesystem::path& file, RunSettings settings, Observer& observer, Provides demands)
    : impl_(std::make_unique<Impl>(file, std::move(settings), observer, demands)) {}

Session::Session(Input input, RunSettings settings, Observer& observer, Provides demands)
    : impl_(std::make_unique<Impl>(std::move(input), std::move(settings), observer, demands)) {}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

const Input& Session::input() const noexcept { return impl_->start.input(); }
const PlacedSurface& Session::surface() const noexcept { return impl_->start.surface(); }
const PluginInfo& Session::solver() const noexcept { return impl_->plugin.info; }
double Session::factor() const noexcept { return impl_->plugin.factor; }

SurfaceReport Session::surface_report() const {
  const std::optional<SampleReport>& sample = impl_->start.sample;
  SurfaceReport report{.facts = sample ? *sample->surface : facts_of(*surface().mesh)};
  if (sample) {
    report.practice = word(sample->practice.verdict);
    report.practice_because = sample->practice.because;
  }
  Json json;
  add_surface(json, impl_->start.opened, sample, report.facts);
  report.json = text_of(json);
  return report;
}

CheckReport Session::check() const { return check_report(impl_->start, impl_->observer); }

std::vector<NamedPoint> Session::select(const std::string& text) const { return impl_->points(parse_selection(text)); }

std::vector<NamedPoint> Session::select(std::span<const Index> rows) const {
  Selection selection;
  for (const Index row : rows) selection.entries.push_back({.index = row});
  return impl_->points(selection);
}

std::vector<NamedPoint> Session::select(std::span<const SurfacePoint> points) const {
  std::vector<NamedPoint> named;
  for (std::size_t i = 0; i < points.size(); ++i)
    named.push_back(point_on(*surface().mesh, points[i], "points[" + std::to_string(i) + "]"));
  return named;
}

std::vector<NamedPoint> Session::select(std::span<const Vec3> positions) const {
  Selection selection;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    const std::string label = "positions[" + std::to_string(i) + "]";
    if (!is_finite(p)) throw OptionError(label + " is not finite");
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > largest_number)
      throw OptionError(label + " has a coordinate beyond 1e100");
    selection.entries.push_back({.kind = PointEntry::Kind::position, .numbers = {p.x, p.y, p.z}, .label = label});
  }
  return impl_->points(selection);
}

std::vector<double> Session::distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                       const DistanceOptions& options) const {
  std::vector<double> out(sources.size() * targets.size());
  distances(sources, targets, out, options);
  return out;
}

void Session::distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, std::span<double> out,
                        const DistanceOptions& options) const {
  if (out.size() != sources.size() * targets.size())
    throw OptionError("there is room for " + std::to_string(out.size()) + " distances, but there are " +
                          std::to_string(sources.size()) + " x " + std::to_string(targets.size()),
                      "give as many entries as there are sources times targets");
  MatrixInMemory<double> matrix(out, sources.size(), targets.size());
  distances(sources, targets, matrix, options);
}

void Session::distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, RowSink& sink,
                        const DistanceOptions& options, std::optional<RowSet> rows) const {
  const RowSet wanted = rows.value_or(RowSet::all(sources.size()));
  check_rows(wanted, sources.size());
  impl_->make_rows(sources, targets, sink, options, wanted, {});
  if (!rows) sink.finish();
}

BoundedDistances Session::bounded_distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                            const DistanceOptions& options) const {
  check_bounds_rule(options.rule);
  check_bounds_metric(impl_->settings.metric);
  demand_lower_bounds(impl_->plugin);
  const std::size_t count = targets.size();
  std::vector<double> both(2 * sources.size() * count);
  MatrixInMemory<double> matrix(both, sources.size(), 2 * count);
  impl_->make_rows(sources, targets, matrix, options, RowSet::all(sources.size()), {.bounds = true});
  BoundedDistances result;
  for (auto row = both.begin(); row != both.end(); row += static_cast<std::ptrdiff_t>(2 * count)) {
    const auto middle = row + static_cast<std::ptrdiff_t>(count);
    result.distances.insert(result.distances.end(), row, middle);
    result.bounds.insert(result.bounds.end(), middle, middle + static_cast<std::ptrdiff_t>(count));
  }
  return result;
}

std::vector<Distance> Session::nearest(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                       double max_distance) const {
  check_limit(max_distance);
  check_starts(sources);
  check_provides(impl_->plugin.info, ProjectionRule::project, sources, targets, max_distance);
  StageContext context = impl_->context("nearest", 1);
  return measured_nearest(impl_->prepared(), sources, TargetList({targets.begin(), targets.end()}, surface()),
                          max_distance, context)
      .distances;
}

PathResult Session::path(const NamedPoint& from, const NamedPoint& to, ProjectionRule rule) const {
  PathResult path;
  impl_->on_path(from, to, rule, [&](const PreparedSolver& solver, const SourceSurface& on, RunContext& context) {
    path = shortest_path(solver, *on.mesh, on.source, *on.targets, context);
    if (!solver.smooth) return;
    path.flat = FlatPath{path.length, path.points, path.positions};
    smooth_path(solver, on.source, *on.targets, path);
  });
  path.from_off_surface = from.off_surface, path.to_off_surface = to.off_surface;
  return path;
}

std::vector<std::string> Session::audit_nearest(std::span<const NamedPoint> sources,
                                                std::span<const NamedPoint> targets, std::span<const Distance> nearest,
                                                double max_distance, double share) const {
  if (nearest.size() != targets.size())
    throw OptionError("there are " + std::to_string(nearest.size()) + " distances, but " +
                          std::to_string(targets.size()) + " targets",
                      "give what `nearest` gave");
  if (!(share > 0 && share <= 1)) throw OptionError("the audit's share must be above 0, up to 1");
  const TargetList list({targets.begin(), targets.end()}, surface());
  StageContext context = impl_->context("audit", 1);
  const PreparedSolver& solver = impl_->prepared();
  MeasuredNearest flat;
  if (solver.smooth) {
    flat = measured_nearest(solver, sources, list, max_distance, context);
    const auto differs = [](const Distance& a, const Distance& b) {
      return a.source != b.source || !(a.value == b.value || (std::isnan(a.value) && std::isnan(b.value)));
    };
    if (const std::size_t j = first_that(differs, nearest, flat.distances); j < nearest.size())
      return {"target " + targets[j].label + " is " + number_text(nearest[j].value) + " away, measured again " +
              number_text(flat.distances[j].value)};
    nearest = flat.flat, max_distance = flat.radius;
  }
  return broken_promises(audit_distances(solver, *surface().mesh, {sources, list, nearest, max_distance}, share,
                                         impl_->settings.seed, context));
}

std::vector<std::string> Session::audit_path(const NamedPoint& from, const NamedPoint& to, const PathResult& path,
                                             ProjectionRule rule) const {
  std::vector<std::string> broken;
  impl_->on_path(from, to, rule, [&](const PreparedSolver& solver, const SourceSurface& on, RunContext& context) {
    broken = solver.smooth ? audit_smooth_path(solver, *on.mesh, on.source, *on.targets, path, context)
                           : geodrome::audit_path(solver, *on.mesh, on.source, *on.targets, path, context);
  });
  return broken;
}

std::vector<std::string> Session::audit_pairs(std::span<const NamedPair> pairs,
                                              std::span<const double> distances) const {
  if (const std::size_t n = pairs.size(); n != distances.size())
    throw OptionError(
        "there are " + std::to_string(distances.size()) + " distances, but " + std::to_string(n) + " pairs",
        "give what `pairs` gave");
  if (impl_->settings.metric == Metric::smooth)
    return audit_searched(surface(), impl_->prepared(), pairs, distances, impl_->settings, impl_->observer);
  StageContext context = impl_->context("audit", 1);
  const PairAudit audit = geodrome::audit_pairs(*surface().mesh, impl_->prepared(), pairs, distances, context,
                                                surface().made_from == InputKind::points);
  return broken_promises(audit, audit.worst_pair);
}

std::vector<double> Session::pairs(std::span<const NamedPair> pairs) const {
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].from.start != 0 || pairs[i].to.start != 0)
      throw OptionError("pair " + std::to_string(i) + " has a start distance, which pairs have not", "set it to 0");
  if (impl_->settings.metric == Metric::smooth)
    return search_pairs(surface(), impl_->prepared(), pairs, impl_->settings, impl_->observer).smooth;
  const unsigned threads = thread_count(impl_->settings);
  StageContext context = impl_->context("queries", threads);
  return ask_pairs(surface(), impl_->prepared(), *impl_->oracle().oracle, pairs, threads, context);
}

}  // namespace geodrome
