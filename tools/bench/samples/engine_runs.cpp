// SPDX-License-Identifier: MIT
#include "tools/bench/samples/engine_runs.hpp"

#include <stdlib.h>
#include <time.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <utility>

#include "engine/report/json.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome::bench {
namespace {

namespace fs = std::filesystem;

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / "geodrome-bench-XXXXXX") {
    std::string name = path_.string();
    if (!mkdtemp(name.data())) throw InputError(InputFault::io, name + " cannot be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// Notes the processor time of the first and the last row that the engine tells of.
class RowClock : public Observer {
 public:
  void progress(std::string_view stage, double) override {
    if (stage != "distances") return;
    const double now = processor_seconds();
    const std::lock_guard lock(mutex_);
    if (rows_++ == 0) first_ = now;
    last_ = now;
  }
  /// A row between the two; 0 if there are too few.
  double row_seconds() const { return rows_ > 1 ? (last_ - first_) / static_cast<double>(rows_ - 1) : 0; }

 private:
  static double processor_seconds() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  std::mutex mutex_;
  std::size_t rows_ = 0;
  double first_ = 0, last_ = 0;
};

/// The entries are the end of the file, row by row.
std::vector<std::vector<double>> read_matrix(const fs::path& file, std::size_t rows, std::size_t columns) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(-static_cast<std::streamoff>(rows * columns * sizeof(double)), std::ios::end);
  std::vector<std::vector<double>> matrix(rows, std::vector<double>(columns));
  for (auto& row : matrix)
    in.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(columns * sizeof(double)));
  if (!in) throw InputError(InputFault::truncated, file.string() + " cannot be read back");
  return matrix;
}

EngineRun run_of(const JobReport& report, std::vector<std::vector<double>> distances, double row_seconds) {
  const Json matrix = Json::parse(report.json).at("matrix");
  EngineRun run{.distances = std::move(distances), .row_seconds = row_seconds};
  if (const auto smooth = matrix.find("smooth"); smooth != matrix.end()) {
    run.estimated_error = smooth->at("mean_estimated_error").get<double>();
    run.smooth_share = smooth->at("share_of_length").get<double>();
  }
  return run;
}

}  // namespace

std::vector<Variant> variants_of(const StageChoice& stages) {
  StageChoice all_kept = stages;
  all_kept.decimator = "none";
  return {{"default", stages},
          {"none", all_kept},
          {"insert", stages, ProjectionRule::insert},
          {"printed", stages, ProjectionRule::printed}};
}

EngineRun engine_distances(const ManifoldTask& task, const Variant& variant, RunSettings settings) {
  const TemporaryFolder folder;
  DistanceJob job;
  job.input = folder / "sample.xyz", job.matrix = folder / "distances.npy";
  write_points(job.input, task.sample.points);
  settings.stages = variant.stages, settings.metric = variant.metric;
  job.settings = std::move(settings);
  job.query = variant.query;
  job.audit_share = 0;
  job.sources.clear();
  for (const Index source : task.sources) job.sources += (job.sources.empty() ? "" : ",") + std::to_string(source);
  RowClock clock;
  const JobReport report = run_distances(job, clock);
  if (!report.broken_promises.empty()) throw NumericalError("broken promise: " + report.broken_promises.front());
  return run_of(report, at_targets(task, read_matrix(job.matrix, task.sources.size(), task.sample.size())),
                clock.row_seconds());
}

}  // namespace geodrome::bench
