// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/torus_runs.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "geodrome/engine/input.hpp"
#include "plugins/common/points/neighbours.hpp"
#include "tools/bench/shapes/torus_truth.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/shapes.hpp"

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

}  // namespace

std::vector<Index> choose_rows(std::size_t points, std::size_t count, std::uint64_t seed) {
  shapes::Random random(seed);
  std::set<Index> chosen;
  while (chosen.size() < std::min(count, points)) chosen.insert(static_cast<Index>(random.index(points)));
  return {chosen.begin(), chosen.end()};
}

TorusTask make_torus_task(std::size_t points, std::size_t sources, std::uint64_t seed) {
  TorusTask task;
  task.sample = shapes::sample("torus", {.points = points, .seed = seed});
  task.sources = choose_rows(points, sources, seed);
  task.epsilon = torus_epsilon(task.sample, seed);
  std::vector<TorusPoint> targets;
  for (const Vec3& p : task.sample.points) targets.push_back(torus_point(p));
  for (const Index source : task.sources) task.truth.push_back(torus_distances(targets[source], targets));
  for (std::size_t i = 0; i < task.sources.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      task.asymmetry =
          std::max(task.asymmetry, std::abs(task.truth[i][task.sources[j]] - task.truth[j][task.sources[i]]));
  return task;
}

double largest_hole(const std::string& shape, const PointSample& sample, std::uint64_t seed) {
  constexpr std::size_t probes = 100'000;
  constexpr std::uint64_t other_numbers = 0x65707369;  // the probes must not be the sample
  const Neighbours tree(sample.points);
  double worst = 0;
  std::vector<Neighbour> found;
  for (const Vec3& p : shapes::sample(shape, {.points = probes, .seed = seed ^ other_numbers}).points) {
    tree.nearest(p, 1, found);
    worst = std::max(worst, found.front().squared_distance);
  }
  return std::sqrt(worst);
}

double torus_epsilon(const PointSample& sample, std::uint64_t seed) {
  return largest_hole("torus", sample, seed) / torus_feature_size;
}

std::vector<Variant> variants_of(const StageChoice& stages) {
  StageChoice all_kept = stages;
  all_kept.decimator = "none";
  return {{"default", stages},
          {"none", all_kept},
          {"insert", stages, ProjectionRule::insert},
          {"printed", stages, ProjectionRule::printed}};
}

std::vector<std::vector<double>> engine_distances(const TorusTask& task, const Variant& variant, RunSettings settings) {
  const TemporaryFolder folder;
  DistanceJob job;
  job.input = folder / "torus.xyz", job.matrix = folder / "distances.npy";
  write_points(job.input, task.sample.points);
  settings.stages = variant.stages;
  job.settings = std::move(settings);
  job.query = variant.query;
  job.audit_share = 0;
  job.sources.clear();
  for (const Index source : task.sources) job.sources += (job.sources.empty() ? "" : ",") + std::to_string(source);
  Observer silent;
  const JobReport report = run_distances(job, silent);
  if (!report.broken_promises.empty()) throw NumericalError("broken promise: " + report.broken_promises.front());
  return read_matrix(job.matrix, task.sources.size(), task.sample.size());
}

}  // namespace geodrome::bench
