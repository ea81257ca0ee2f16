// SPDX-License-Identifier: MIT
#include "engine/jobs/start.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/jobs/part.hpp"
#include "engine/report/off_surface_text.hpp"
#include "engine/search/prepared_solver.hpp"
#include "engine/surface/smooth_fit.hpp"

namespace geodrome {

namespace {

/// That a mesh has a boundary or several components is no news to whoever made it: `check` and the report say so.
/// That its weights do not count may be.
bool is_no_news(const Finding& finding) {
  return finding.severity == Finding::Severity::note && finding.code != "weights_not_used";
}

/// A mesh needs none of stages 1 to 4: whoever chose plugins for them should know that they do not run.
void tell_unused(const StageChoice& chosen, Observer& observer) {
  const StageChoice standard;
  const bool same = chosen.tangent == standard.tangent && chosen.control == standard.control &&
                    chosen.decimator == standard.decimator && chosen.reconstructor == standard.reconstructor;
  if (!same)
    tell({{Finding::Severity::warning,
           "stages_not_used",
           "the input is a mesh: the stages chosen for point samples do not run",
           0,
           {},
           remedies::take_vertices()}},
         observer);
}

void tell_input(const Input& input, const RunSettings& settings, Observer& observer) {
  std::vector<Finding> findings = input.findings;
  if (input.kind == InputKind::mesh) std::erase_if(findings, is_no_news);
  tell(findings, observer);
  if (input.kind == InputKind::mesh) tell_unused(settings.stages, observer);
}

/// Whoever reads nothing but warnings must know that not all is measured.
void add_part_finding(PlacedSurface& surface) {
  const SurfacePart& part = *surface.part;
  const std::size_t others = part.sample - part.points;
  if (others > 0)
    surface.findings.push_back(
        {Finding::Severity::warning,
         "part",
         "the surface is of a part of the sample, " + text_of(part) + ": the others have no distances (nan)",
         others,
         {},
         {}});
}

/// The report on a sample as a whole, whose refusal it completes; none for a mesh. `found`: the part that was looked
/// for because the whole is refused or because `wanted` says so.
std::optional<SampleReport> report_on(const Input& input, SurfaceAttempt& whole, const std::optional<FoundPart>& found,
                                      bool wanted, std::optional<double> factor, std::uint64_t seed) {
  if (!whole.surface.sample) return std::nullopt;
  if (wanted && !whole.refusal) {
    const SampleReport report = make_sample_report(input, whole.surface, nullptr, factor, seed);
    whole.refusal = without_part(report);
    whole.surface.mesh.reset(), whole.surface.locator.reset(), whole.surface.inserter.reset();
    whole.surface.places.clear();
  } else if (whole.refusal && has_candidates(whole)) {
    whole.refusal = with_part(*whole.refusal, found);
  }
  const SampleError* refusal = whole.refusal ? &*whole.refusal : nullptr;
  if (refusal) factor.reset();  // no solver runs
  SampleReport report = make_sample_report(input, whole.surface, refusal, factor, seed);
  if (refusal && has_candidates(whole))
    report.part = found ? found->surface.part : SurfacePart{.sample = input.positions.size()};
  return report;
}

}  // namespace

void tell(const std::vector<Finding>& findings, Observer& observer) {
  for (const Finding& finding : findings)
    observer.log(finding.severity == Finding::Severity::note ? LogLevel::info : LogLevel::warning,
                 text_of(finding, observer));
}

OffSurface tell_off_surface(const Input& input, const PlacedSurface& surface, std::initializer_list<ResolvedList> lists,
                            Observer& observer) {
  OffSurfaceFinder finder(input, surface);
  for (const auto& [selection, points] : lists) finder.add(selection, points);
  tell(findings_of(finder.found()), observer);
  return finder.found();
}

SolverPlugin load_solver(const PluginHost& host, const std::string& selection, Provides demands) {
  SolverPlugin plugin = host.load<ShortestPathSolver>(selection);
  demand(plugin.info, demands);
  return plugin;
}

Input read_and_tell(const std::filesystem::path& file, const RunSettings& settings, Observer& observer) {
  Input input = read_input(file, settings.read);
  tell_input(input, settings, observer);
  return input;
}

JobStart start_quietly(Input input, const PluginHost& host, const RunSettings& settings, std::optional<double> factor,
                       Observer& observer) {
  JobStart start{{.input = std::move(input)}, std::nullopt};
  Opened& opened = start.opened;
  const Stopwatch watch;
  const bool of_part = settings.part == Part::largest;
  if (of_part && opened.input.kind == InputKind::mesh)
    throw OptionError("a part is of a point sample: a mesh is taken as it is", remedies::whole_or_points());
  if (settings.metric == Metric::smooth) load_smooth_estimator(host, settings);
  SurfaceAttempt attempt = try_surface(opened.input, host, settings, observer);
  std::optional<FoundPart> part;
  if (attempt.surface.sample && (of_part || attempt.refusal))
    part = find_part(opened.input, attempt, host, settings, factor, observer);
  if (of_part && part) {
    opened.surface = std::move(part->surface), start.sample = std::move(part->report);
    add_part_finding(opened.surface);
  } else {
    start.sample = report_on(opened.input, attempt, part, of_part, factor, settings.seed);
    opened.surface = std::move(attempt.surface), opened.refusal = std::move(attempt.refusal);
  }
  if (settings.metric == Metric::smooth && !opened.refusal) {
    opened.surface.smooth = fit_smooth(opened.surface, {opened.input.positions}, host, settings, observer);
    settle_places(opened.surface);
  }
  opened.surface_seconds = watch.seconds();
  return start;
}

JobStart start_job(Input input, const PluginHost& host, const RunSettings& settings, std::optional<double> factor,
                   Observer& observer) {
  tell_input(input, settings, observer);
  JobStart start = start_quietly(std::move(input), host, settings, factor, observer);
  tell(start.surface().findings, observer);
  return start;
}

JobStart start_job(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                   std::optional<double> factor, Observer& observer) {
  const Stopwatch watch;
  Input input = read_input(file, settings.read);
  const double seconds = watch.seconds();
  JobStart start = start_job(std::move(input), host, settings, factor, observer);
  start.opened.read_seconds = seconds;
  return start;
}

void throw_if_refused(const JobStart& start, Observer& observer) {
  if (!start.opened.refusal) return;
  for (const std::string& line : lines_of(start.sample->worst)) observer.log(LogLevel::warning, line);
  throw *start.opened.refusal;
}

void tell_sample(const JobStart& start, Observer& observer) {
  if (!start.sample) return;
  TextOutput text;
  text.precision(4);
  print_short(*start.sample, text);
  TextInput lines(text.str());
  for (std::string line; std::getline(lines, line);) observer.log(LogLevel::info, line);
}

}  // namespace geodrome
