// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstring>

#include "tests/faults/campaign.hpp"

namespace geodrome::faults {

namespace {

constexpr int signals[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP};

/// A signal that comes before the program listens ends it; nothing is made by then. A job that tells failures runs in
/// processes of its own: one that is killed is told, with the status of a crash.
Expected expected_of(int signal, const Job& job) {
  if (signal != SIGKILL) return {.statuses = {0, 130, 128 + signal}};
  Expected expected{.statuses = {0, 128 + SIGKILL}, .may_be_killed = true};
  if (job.tells_failures) expected.statuses.insert(5);
  return expected;
}

/// At the calls that make or change files, where a moment matters most.
void signal_at_calls(Campaign& campaign, Judge& judge) {
  for (const char* call :
       {"create", "write", "pwrite", "fsync", "ftruncate", "fallocate", "close", "rename", "unlink"}) {
    campaign.lab.prepare(judge.job());
    const unsigned long calls = campaign.lab.run(judge.job().arguments, {.fault = Fault{.call = call}}).calls;
    for (unsigned long at = 1; at <= calls; ++at)
      for (const int signal : signals) {
        if (!campaign.all && campaign.any(calls * std::size(signals)) > 0) continue;
        const Fault fault{.call = call, .at = at, .act = "signal:" + std::to_string(signal)};
        Ended ended;
        const std::string complaint = judge.trial({.fault = fault}, expected_of(signal, judge.job()), ended);
        campaign.note("signal at", judge.job().name, fault.text(), ended,
                      ended.struck ? complaint : "the fault did not come");
      }
  }
}

/// At allocations, which are everywhere: in libraries too.
void signal_at_allocations(Campaign& campaign, Judge& judge, int times) {
  campaign.lab.prepare(judge.job());
  const unsigned long calls = campaign.lab.run(judge.job().arguments, {.fault = Fault{.call = "malloc"}}).calls;
  for (int i = 0; i < times; ++i) {
    const int signal = signals[campaign.any(std::size(signals))];
    const Fault fault{.call = "malloc", .at = campaign.any(calls) + 1, .act = "signal:" + std::to_string(signal)};
    Ended ended;
    const std::string complaint = judge.trial({.fault = fault}, expected_of(signal, judge.job()), ended);
    campaign.note("signal in", judge.job().name, fault.text(), ended, complaint);
  }
}

/// A moment of the run, or a little after it.
double any_moment(Campaign& campaign, const Judge& judge) {
  constexpr std::uint64_t parts = 1'000'000;
  return 1.1 * judge.seconds() * static_cast<double>(campaign.any(parts)) / parts;
}

void signal_at_random(Campaign& campaign, Judge& judge, int signal, int times) {
  for (int i = 0; i < times; ++i) {
    const double after = any_moment(campaign, judge);
    Ended ended;
    const std::string complaint =
        judge.trial({.signal = signal, .after = after}, expected_of(signal, judge.job()), ended);
    campaign.note(sigabbrev_np(signal), judge.job().name, "after " + std::to_string(after) + " s", ended, complaint);
  }
}

/// Kills a matrix again and again, until it is done in spite of it, and so on: no row that is on record is ever lost.
void kill_and_resume(Campaign& campaign, const Judge& judge, int times) {
  const Job& job = judge.job();
  std::vector<std::string> resumed = job.arguments;
  resumed.push_back("--resume");
  campaign.lab.prepare(job);
  std::uint64_t rows = 0;
  for (int i = 0; i < times; ++i) {
    const Ended ended = campaign.lab.run(resumed, {.signal = SIGKILL, .after = any_moment(campaign, judge)});
    std::string complaint = judge.complaint(ended, expected_of(SIGKILL, job));
    const Files files = campaign.lab.files();
    const std::uint64_t now = rows_on_record(files, job);
    const bool published = files.contains(job.outputs[0]);
    if (complaint.empty() && !published && now < rows)
      complaint = std::to_string(rows) + " rows were on record, and now " + std::to_string(now);
    campaign.note("KILL, resume", job.name, "kill " + std::to_string(i), ended, complaint);
    rows = now;
    if (published) campaign.lab.prepare(job), rows = 0;
  }
}

void ignore_what_the_caller_ignores(Campaign& campaign, Judge& judge) {
  for (const int signal : {SIGHUP, SIGINT}) {
    const Fault fault{.call = "pwrite", .at = 20, .times = 2, .act = "signal:" + std::to_string(signal)};
    Ended ended;
    const std::string complaint = judge.trial({.fault = fault, .ignored = signal}, {.statuses = {0}}, ended);
    campaign.note("signal ignored", judge.job().name, fault.text(), ended,
                  ended.struck ? complaint : "the fault did not come");
  }
}

}  // namespace

void try_signals(Campaign& campaign) {
  for (const Job& job : campaign.jobs) {
    if (!campaign.wants("signals", job.name)) continue;
    Judge judge(campaign.lab, job);
    signal_at_calls(campaign, judge);
    signal_at_allocations(campaign, judge, campaign.all ? 100 : 3);
    const bool is_long = job.name == "threads" || job.name == "queries" || job.name == "nearest";
    if (!campaign.all && !is_long) continue;
    if (job.name == "threads") ignore_what_the_caller_ignores(campaign, judge);
    if (job.name == "threads") kill_and_resume(campaign, judge, campaign.all ? 200 : 10);
    const int times = campaign.all && is_long ? 200 : 5;
    signal_at_random(campaign, judge, SIGKILL, times);
    for (const int signal : {SIGTERM, SIGINT}) signal_at_random(campaign, judge, signal, campaign.all ? times / 4 : 1);
  }
}

}  // namespace geodrome::faults
