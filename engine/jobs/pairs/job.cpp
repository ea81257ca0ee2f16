// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "engine/formats/ending.hpp"
#include "engine/formats/npy.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/pairs/report.hpp"
#include "engine/jobs/session_state.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/posix_file.hpp"
#include "engine/report/off_surface_text.hpp"
#include "engine/search/named_points.hpp"

namespace geodrome {

namespace {

/// Mistakes that would otherwise show after the oracle is built.
void check_arguments(const PairJob& job) {
  if (job.pairs.empty()) throw OptionError("no pairs are named", "name a file with a pair a line");
  if (job.out.empty()) throw OptionError("nothing to write", remedies::pairs_output());
  check_ending(job.out, Content::pairs);
  check_ending(job.report, Content::report);
  if (job.settings.metric == Metric::smooth && !job.index.empty())
    throw OptionError("an index is of an oracle, which measures on the triangles; smooth distances are searched for",
                      remedies::no_index_or_flat_metric());
  const bool index_is_read = !job.index.empty() && file_exists(job.index);
  std::vector<std::filesystem::path> read{job.input, job.pairs}, written{job.out, job.report};
  if (!job.index.empty()) (index_is_read ? read : written).push_back(job.index);
  check_outputs(written, read);
}

PairDistances asked(const SessionState& session, const ReadyOracle& oracle, std::span<const NamedPair> pairs,
                    const PreparedSolver& solver) {
  const unsigned threads = thread_count(session.settings);
  StageContext context = session.context("queries", threads);
  return pair_distances(session.start.surface(), solver, *oracle.oracle, pairs, threads, context);
}

std::string as_csv(std::span<const NamedPair> pairs, std::span<const double> values) {
  std::string text = "pair,from,to,distance,reach\n";
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    text += std::to_string(i) + "," + pairs[i].from.label + "," + pairs[i].to.label + ",";
    text += std::isnan(values[i]) ? "nan" : number_text(values[i]);  // without the sign of a NaN
    const bool from_is_off = pairs[i].from.place.state == Place::State::off_part;
    const Place& place = from_is_off ? pairs[i].from.place : pairs[i].to.place;
    const Reach reach = std::isinf(values[i]) ? Reach::unreachable : Reach::reached;
    text += std::string(",") + reach_word(values[i], reach, place) + "\n";
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
  SessionState session(job.settings, observer, Provides::nothing);
  const bool smooth = job.settings.metric == Metric::smooth;
  if (!smooth) demand_pair_queries(session.plugin.info, session.host);
  PairSelection selection = parse_pairs(job.pairs);  // after the solver: the file may have millions of lines
  session.begin(job.input);
  const JobStart& start = session.start;
  if (start.opened.refusal && !job.report.empty()) write_atomically(job.report, refusal_report(job, start) + "\n");
  throw_if_refused(start, observer);
  const PlacedSurface& surface = start.surface();
  const PairList list = resolve(selection, start.input(), surface);
  OffSurfaceFinder off(start.input(), surface);
  off.add(std::exchange(selection, {}), list);
  tell(findings_of(off.found()), observer);
  const PreparedSolver& solver = session.prepared();
  const ReadyOracle* oracle = smooth ? nullptr : &session.oracle(job.index);
  const PairDistances distances = smooth ? pair_distances(surface, solver, list.pairs, job.settings, observer)
                                         : asked(session, *oracle, list.pairs, solver);
  const bool csv = has_ending(job.out, ".csv");
  write_atomically(job.out, csv ? as_csv(list.pairs, distances.values) : as_npy(distances.values));
  const JobReport report = write_report({job, start, solver, list, oracle, distances, off.found(), total.seconds()});
  if (!job.report.empty()) write_atomically(job.report, report.json + "\n");
  return report;
}

}  // namespace geodrome
