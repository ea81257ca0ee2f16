// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/audit_figures.hpp"

#include <algorithm>
#include <random>

#include "tools/bench/solvers/own_process.hpp"

namespace geodrome::bench {

namespace {

class Silent final : public Observer {};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

bool breaks_a_promise(const DistanceJob& job) {
  Silent observer;
  try {
    return !run_distances(job, observer).broken_promises.empty();
  } catch (const NumericalError&) {
    return true;
  } catch (const PluginError&) {
    return true;
  }
}

std::string random_rows(std::size_t vertices, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string rows;
  for (std::size_t i = 0; i < count; ++i) rows += (i > 0 ? "," : "") + std::to_string(random() % vertices);
  return rows;
}

}  // namespace

DistanceJob AuditJobs::job(const std::string& sources, bool nearest, double audit_share, std::uint64_t seed) const {
  DistanceJob job;
  job.input = mesh, job.sources = sources, job.audit_share = audit_share;
  job.settings.stages.solver = solver, job.settings.plugin_path = plugin_path;
  job.settings.threads = 1, job.settings.seed = seed;
  (nearest ? job.nearest : job.matrix) = folder / (nearest ? "nearest.csv" : "matrix.npy");
  return job;
}

AuditCost audit_cost(const AuditJobs& jobs, const std::string& sources, bool nearest, std::size_t rounds) {
  std::vector<double> figures[4];
  for (std::size_t round = 0; round < rounds; ++round)
    for (const bool audited : {false, true}) {
      const ProcessCost cost = in_a_process_of_its_own([&] {
        Silent observer;
        run_distances(jobs.job(sources, nearest, audited ? jobs.share : 0, 1), observer);
      });
      if (!cost.well) throw RefusedError("the job cannot be measured");
      figures[audited].push_back(cost.seconds);
      figures[2 + audited].push_back(static_cast<double>(cost.peak_bytes));
    }
  return {median(figures[0]), median(figures[1]), median(figures[2]), median(figures[3])};
}

AuditPower audit_power(const AuditJobs& jobs, std::size_t vertices, std::size_t sources, bool nearest,
                       std::size_t seeds) {
  AuditPower power;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::string rows = random_rows(vertices, sources, seed);
    power.found += breaks_a_promise(jobs.job(rows, nearest, jobs.share, seed));
    power.found_without += breaks_a_promise(jobs.job(rows, nearest, 0, seed));
  }
  return power;
}

}  // namespace geodrome::bench
