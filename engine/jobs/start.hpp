// SPDX-License-Identifier: MIT
#pragma once

#include "engine/report/sample_report.hpp"
#include "engine/surface/off_surface.hpp"
#include "engine/surface/opened.hpp"
#include "geodrome/engine/pipeline.hpp"

/// The head of every job. Mistakes are told in the order in which they are cheap to find: arguments and the syntax of
/// lists, then the solver and what it provides, then files of pairs, then the input, then the plugins of stages 1 to 4,
/// and only then does stage 1 run.
namespace geodrome {

using SolverPlugin = Plugin<ShortestPathSolver>;

/// Tells the observer of findings: of notes as information, of all others as warnings.
void tell(const std::vector<Finding>& findings, Observer& observer);

/// A list, and the points that it names.
struct ResolvedList {
  const Selection& selection;
  const std::vector<NamedPoint>& points;
};

/// Finds what the lists name off the surface, and tells the observer what there is to warn of.
OffSurface tell_off_surface(const Input& input, const PlacedSurface& surface, std::initializer_list<ResolvedList> lists,
                            Observer& observer);

/// Loads the solver that was chosen. Throws as PluginHost::load, and CapabilityError if it lacks one of `demands`,
/// which are those of the job whatever the surface.
SolverPlugin load_solver(const PluginHost& host, const std::string& selection, Provides demands = Provides::nothing);

/// Reads and checks the file, and tells the observer what was found (of a mesh: warnings only).
Input read_and_tell(const std::filesystem::path& file, const RunSettings& settings, Observer& observer);

/// The input, the surface and, for a cloud, the sample's report that a job starts from.
struct JobStart {
  Opened opened;
  std::optional<SampleReport> sample;  ///< of a cloud, refused or not

  const Input& input() const { return opened.input; }
  const PlacedSurface& surface() const { return opened.surface; }
};

/// Runs stages 1 to 4 on the input. `factor`: that of the job's solver; none if the job has none. Throws what the
/// stages throw, but for SampleError, which is kept as `opened.refusal`.
JobStart start_quietly(Input input, const PluginHost& host, const RunSettings& settings, std::optional<double> factor,
                       Observer& observer);

/// Does so, and tells the observer what was found in input and surface.
JobStart start_job(Input input, const PluginHost& host, const RunSettings& settings, std::optional<double> factor,
                   Observer& observer);

/// Reads the file first, and keeps the time that it took.
JobStart start_job(const std::filesystem::path& file, const PluginHost& host, const RunSettings& settings,
                   std::optional<double> factor, Observer& observer);

/// If the sample was refused: tells the observer the worst places, then throws the refusal.
void throw_if_refused(const JobStart& start, Observer& observer);

/// Tells the observer the sample report in short, if there is one: for jobs without a report of their own.
void tell_sample(const JobStart& start, Observer& observer);

}  // namespace geodrome
