// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/formats/ending.hpp"
#include "engine/formats/npy.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/host/stage_context.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/pairs/report.hpp"
#include "engine/output/atomic_file.hpp"

namespace geodrome {

namespace {

/// Mistakes that would otherwise show after the oracle is built.
void check_arguments(const PairJob& job) {
  if (job.pairs.empty()) throw OptionError("no pairs are named", "name a file with a pair a line");
  if (job.out.empty()) throw OptionError("nothing to write", remedies::pairs_output());
  check_ending(job.out, Content::pairs);
  check_ending(job.report, Content::report);
  const bool index_is_read = !job.index.empty() && std::filesystem::exists(job.index);
  std::vector<std::filesystem::path> read{job.input, job.pairs}, written{job.out, job.report};
  if (!job.index.empty()) (index_is_read ? read : written).push_back(job.index);
  check_outputs(written, read);
}

const char* reach_word(double value) {
  if (std::isnan(value)) return "dropped";
  return std::isinf(value) ? "unreachable" : "reached";
}

std::string as_csv(std::span<const NamedPair> pairs, std::span<const double> values) {
  std::string text = "pair,from,to,distance,reach\n";
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    text += std::to_string(i) + "," + pairs[i].from.label + "," + pairs[i].to.label + ",";
    text += std::isnan(values[i]) ? "nan" : number_text(values[i]);  // without the sign of a NaN
    text += std::string(",") + reach_word(values[i]) + "\n";
  }
  return text;
}

std::string as_npy(std::span<const double> values) {
  std::string bytes = npy_header(values.size(), ScalarType::float64);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return bytes;
}

}  // namespace

JobReport run_pairs(const PairJob& job, Observer& observer) {
  const Stopwatch total;
  check_arguments(job);
  const PluginHost host(job.settings.plugin_path);
  // Loaded again below, from the registry: what cannot be done is told before a surface is made.
  demand_pair_queries(host.load<ShortestPathSolver>(job.settings.stages.solver).info, host);
  const Opened opened = try_open(job.input, host, job.settings, observer);
  if (opened.refusal && !job.report.empty()) write_atomically(job.report, refusal_report(job, opened) + "\n");
  throw_if_refused(opened, job.settings, observer);
  const PairList list = select_pairs(job.pairs, opened.input, opened.surface);
  const PreparedSolver solver =
      prepare_solver(opened.surface.mesh, host, job.settings.stages.solver, job.settings, observer);
  const ReadyOracle oracle = ready_oracle(*opened.surface.mesh, solver, job.index, job.settings, observer);
  const unsigned threads = thread_count(job.settings);
  StageContext context("queries", observer, threads, job.settings.seed);
  const PairDistances distances = pair_distances(opened.surface, solver, *oracle.oracle, list.pairs, threads, context);
  const bool csv = has_ending(job.out, ".csv");
  write_atomically(job.out, csv ? as_csv(list.pairs, distances.values) : as_npy(distances.values));
  const JobReport report = write_report({job, opened, solver, list, oracle, distances, total.seconds()});
  if (!job.report.empty()) write_atomically(job.report, report.json + "\n");
  return report;
}

}  // namespace geodrome
