// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "engine/formats/remedies.hpp"
#include "engine/host/apart.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/compare/checks.hpp"
#include "engine/jobs/compare/growth.hpp"
#include "engine/jobs/compare/json.hpp"
#include "engine/jobs/compare/page.hpp"
#include "engine/jobs/compare/smooth.hpp"
#include "engine/jobs/compare/text.hpp"
#include "engine/jobs/compare/view.hpp"
#include "engine/jobs/start.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/float32_loss.hpp"
#include "engine/search/named_points.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

namespace {

/// Mistakes that would otherwise show after all is computed.
void check_arguments(const CompareJob& job) {
  if (job.settings.part != Part::whole)
    throw OptionError("combinations are compared on whole samples: each would find another part",
                      remedies::whole_sample());
  check_ending(job.figures, Content::figures);
  check_ending(job.page, Content::page);
  const std::string selections[] = {job.sources};
  std::vector<std::filesystem::path> read = files_read(job.input, job.settings.read, selections);
  if (auto file = truth_file(job.truth); !file.empty()) read.push_back(std::move(file));
  const std::filesystem::path outputs[] = {job.figures, job.page};
  check_outputs(outputs, read);
}

/// Rows that do not exist are told though no combination may come as far as to place them.
void check_rows(const Selection& sources, const Input& input) {
  Selection rows{.file = sources.file};
  std::ranges::copy_if(sources.entries, std::back_inserter(rows.entries),
                       [](const PointEntry& entry) { return entry.kind == PointEntry::Kind::row; });
  PlacedSurface anywhere;
  anywhere.places.resize(input.element_of_row.size());
  resolve(rows, input, anywhere);
}

/// Times are comparable on one thread only.
RunSettings on_one_thread(RunSettings settings) {
  settings.threads = 1;
  return settings;
}

/// The comparison of combinations on one input, as far as it has come.
class Comparison {
 public:
  Comparison(const CompareJob& job, const Selection& sources, const PluginHost& host, const RunSettings& settings,
             const Input& input, Observer& observer)
      : job_(job),
        selection_(sources),
        host_(host),
        settings_(settings),
        input_(input),
        observer_(observer),
        surfaces_(input, host, settings, observer,
                  [this, &sources](const PlacedSurface& surface) { return resolve(sources, input_, surface); }),
        truth_(job.truth, input, host, settings, observer),
        growth_(job.growth, input, host, settings, observer),
        view_(input, job.paths, settings.seed) {}

  void add(const Combination& combination) {
    CombinationFigures figures = begun(combination);
    SolverPlugin solver;
    std::shared_ptr<const PlacedSurface> surface;
    attempt(figures, [&] {
      solver = load_solver(host_, combination.choice.solver,
                           settings_.metric == Metric::smooth ? Provides::paths : Provides::nothing);
      surface = surfaces_.make(combination.choice);
    });
    // A mesh is a surface without any plugin: what is wrong with the sources is told though no solver can be loaded.
    if (!surface && input_.kind == InputKind::mesh) surface = surfaces_.make(combination.choice);
    if (surface) {
      const auto on = surfaces_.placed(surface);  // what is wrong with the sources is wrong for all,
      truth_.read_file(*on);                      // and what is wrong with the file
      if (sources_.empty()) {
        sources_ = on->sources;
        tell_off_surface(input_, *surface, {{selection_, sources_}}, observer_);
        tell_of_page(*surface->mesh);
      }
      if (figures.ran()) attempt(figures, [&] { fill(figures, combination, solver, on); });
    }
    keep(std::move(figures));
  }

  /// A combination whose process died.
  void add_lost(const Combination& combination, const LostStep& lost) {
    CombinationFigures figures = begun(combination);
    figures.error = lost.reason, figures.error_status = lost.status;
    keep(std::move(figures));
  }

  ComparisonFigures figures() const {
    ComparisonFigures result{.file = input_.file.string(),
                             .kind = input_.kind,
                             .rows = input_.element_of_row.size(),
                             .faces = input_.triangles.size(),
                             .diagonal = input_.facts.bounding_box_diagonal,
                             .truth = truth_.figures(),
                             .combinations = combinations_};
    for (const NamedPoint& source : sources_) result.sources.push_back(told(source));
    return result;
  }

  Json view() const { return view_.json(); }

 private:
  CombinationFigures begun(const Combination& combination) const {
    return {.name = combination.name, .stages = choices_by_stage(combination.choice, input_.kind)};
  }

  void keep(CombinationFigures figures) {
    if (!figures.ran() && !job_.page.empty()) view_.add_failed();
    combinations_.push_back(std::move(figures));
  }

  /// An error is the combination's own: the others go on.
  template <class Function>
  void attempt(CombinationFigures& figures, Function&& function) {
    try {
      function();
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      figures.error = text_of(error, observer_);
      figures.error_status = exit_status(error);
    }
  }

  /// The page shows the surface in 32-bit floats.
  void tell_of_page(const SurfaceMesh& mesh) {
    if (job_.page.empty()) return;
    std::vector<Finding> told = float32_loss(job_.page, mesh);
    for (Finding& finding : told)
      finding.remedy = "its numbers are right, its picture is not; subtract a common offset";
    tell(told, observer_);
  }

  void fill(CombinationFigures& figures, const Combination& combination, const SolverPlugin& solver,
            const std::shared_ptr<const ComparedSurface>& on) {
    judge(figures, combination.name, solver, *on);
    figures.growth = growth_.of(combination, solver, on, figures.cost);
  }

  void judge(CombinationFigures& figures, const std::string& name, const SolverPlugin& solver,
             const ComparedSurface& on) {
    const Measurement measured = measure(on, solver, host_, settings_, name, observer_);
    std::optional<SmoothMeasurement> smooth;
    if (on.metric) smooth = measure_smooth(on, measured.solver, settings_, name, observer_);
    const DistanceRows& true_rows = truth_.rows(name, on, measured.rows);
    for (const StageRecord& stage : on.surface->stages)
      figures.stage_seconds.emplace_back(stage.plugin.stage, stage.seconds);
    figures.cost = measured.cost;
    figures.factor = measured.solver.plugin.factor;
    figures.never_shorter = measured.solver.provides(Provides::never_shorter);
    figures.certified = measured.certified;
    figures.errors = compare_distances(measured.rows, true_rows);
    figures.invariants = checks_of(on, measured, measured.rows, 0, settings_.seed);
    figures.guarantee = guarantee_of(on, measured, true_rows, truth_);
    if (smooth) figures.smooth = judged(*smooth, measured, on);
    if (!job_.page.empty()) view_.add(on, measured, true_rows, observer_);
  }

  SmoothComparison judged(const SmoothMeasurement& smooth, const Measurement& measured, const ComparedSurface& on) {
    return {.source_seconds = smooth.source_seconds,
            .paths = smooth.paths,
            .errors = compare_distances(smooth.rows, truth_.smooth_rows(on, smooth.rows)),
            .invariants = checks_of(on, measured, smooth.rows, smooth.paths.largest_change, settings_.seed)};
  }

  ComparedSource told(const NamedPoint& source) const {
    if (source.row == no_index) return {source.label, std::nullopt, source.place.position, source.off_surface};
    const Index element = input_.element_of_row[source.row];  // its place is lost where it was dropped
    return {source.label, source.row, element == no_index ? Vec3{} : input_.positions[element]};
  }

  const CompareJob& job_;
  const Selection& selection_;
  const PluginHost& host_;
  const RunSettings& settings_;
  const Input& input_;
  Observer& observer_;
  ComparedSurfaces surfaces_;
  ComparisonTruth truth_;
  ComparisonGrowth growth_;
  ComparisonView view_;
  std::vector<NamedPoint> sources_;  // on the first surface
  std::vector<CombinationFigures> combinations_;
};

int first_error_status(const ComparisonFigures& figures) {
  for (const CombinationFigures& combination : figures.combinations)
    if (!combination.ran()) return combination.error_status;
  return 0;
}

CompareReport finish(const CompareJob& job, const Comparison& comparison, const std::optional<ComparisonPage>& page) {
  const ComparisonFigures figures = comparison.figures();
  Json json = to_json(figures);
  CompareReport report{text_of(json), text_of(figures), first_error_status(figures), broken_promises(figures)};
  if (!job.figures.empty()) write_atomically(job.figures, report.json + "\n");
  if (page) {
    json["view"] = comparison.view();
    write_atomically(job.page, page->with(json.dump(-1, ' ', false, Json::error_handler_t::replace)));
  }
  return report;
}

Apart::Strings strings_of(const CompareReport& report) {
  Apart::Strings strings{report.json, report.table, std::to_string(report.error_status)};
  strings.insert(strings.end(), report.broken_promises.begin(), report.broken_promises.end());
  return strings;
}

CompareReport report_of(const Apart::Strings& strings) {
  return {strings[0], strings[1], std::stoi(strings[2]), {strings.begin() + 3, strings.end()}};
}

}  // namespace

CompareReport run_compare(const CompareJob& job, Observer& observer) {
  std::vector<VariedStage> varied;
  for (const std::string& text : job.varied) varied.push_back(parse_varied_stage(text));
  check_arguments(job);
  const std::optional<ComparisonPage> page =
      job.page.empty() ? std::nullopt : std::make_optional<ComparisonPage>(job.page_template);
  const Selection sources = parse_selection(job.sources);
  const RunSettings settings = on_one_thread(job.settings);
  const PluginHost host(settings.plugin_path);
  const Input input = read_and_tell(job.input, settings, observer);
  const std::vector<Combination> combinations = combinations_of(varied, settings.stages, input.kind);
  check_rows(sources, input);
  const auto compare = [&](Apart& apart, Observer& told) {
    Comparison comparison(job, sources, host, settings, input, told);
    for (const Combination& combination : combinations)
      if (const auto lost = apart.before_step())
        comparison.add_lost(combination, *lost);
      else
        comparison.add(combination);
    return strings_of(finish(job, comparison, page));
  };
  return report_of(Apart::run(compare, observer));
}

}  // namespace geodrome
