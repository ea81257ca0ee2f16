// SPDX-License-Identifier: MIT
#include "engine/surface/opened.hpp"

#include <sstream>

#include "engine/formats/remedies.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/report/sample_report.hpp"

namespace geodrome {

namespace {

void tell(const std::vector<Finding>& findings, Observer& observer) {
  for (const Finding& finding : findings)
    observer.log(finding.severity == Finding::Severity::note ? LogLevel::info : LogLevel::warning,
                 text_of(finding, observer));
}

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

void tell_sample(const Opened& opened, const RunSettings& settings, Observer& observer) {
  std::stringstream text;
  text.precision(4);
  print_short(make_sample_report(opened.input, opened.surface, nullptr, std::nullopt, settings.seed), text);
  for (std::string line; std::getline(text, line);) observer.log(LogLevel::info, line);
}

}  // namespace

Input read_and_tell(const std::filesystem::path& file, const RunSettings& settings, Observer& observer) {
  Input input = read_input(file, settings.read);
  std::vector<Finding> findings = input.findings;
  if (input.kind == InputKind::mesh) std::erase_if(findings, is_no_news);
  tell(findings, observer);
  if (input.kind == InputKind::mesh) tell_unused(settings.stages, observer);
  return input;
}

Opened try_open(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                Observer& observer) {
  Opened opened;
  const Stopwatch reading;
  opened.input = read_and_tell(file, settings, observer);
  opened.read_seconds = reading.seconds();
  const Stopwatch making;
  SurfaceAttempt attempt = try_surface(opened.input, host, settings, observer);
  opened.surface = std::move(attempt.surface), opened.refusal = std::move(attempt.refusal);
  opened.surface_seconds = making.seconds();
  tell(opened.surface.findings, observer);
  return opened;
}

void throw_if_refused(const Opened& opened, const RunSettings& settings, Observer& observer) {
  if (!opened.refusal) return;
  const SampleReport report =
      make_sample_report(opened.input, opened.surface, &*opened.refusal, std::nullopt, settings.seed);
  for (const std::string& line : lines_of(report.worst)) observer.log(LogLevel::warning, line);
  throw *opened.refusal;
}

Opened open_input(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                  Observer& observer) {
  Opened opened = try_open(file, host, settings, observer);
  throw_if_refused(opened, settings, observer);
  if (opened.surface.sample) tell_sample(opened, settings, observer);
  return opened;
}

}  // namespace geodrome
