// SPDX-License-Identifier: MIT
#include "engine/jobs/start.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/report/off_surface_text.hpp"
#include "engine/search/prepared_solver.hpp"

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
  SurfaceAttempt attempt = try_surface(opened.input, host, settings, observer);
  opened.surface = std::move(attempt.surface), opened.refusal = std::move(attempt.refusal);
  opened.surface_seconds = watch.seconds();
  if (!opened.surface.sample) return start;
  const SampleError* refusal = opened.refusal ? &*opened.refusal : nullptr;
  if (refusal) factor.reset();  // no solver runs
  start.sample = make_sample_report(opened.input, opened.surface, refusal, factor, settings.seed);
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
