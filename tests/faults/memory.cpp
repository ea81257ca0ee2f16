// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cmath>

#include "tests/faults/campaign.hpp"

namespace geodrome::faults {

namespace {

/// A number from 1 to `most`, small ones as likely as large ones: each power of two has the same share.
unsigned long any_place(Campaign& campaign, unsigned long most) {
  constexpr std::uint64_t parts = 1'000'000;
  const double part = static_cast<double>(campaign.any(parts)) / parts;
  return static_cast<unsigned long>(std::pow(static_cast<double>(most), part));
}

void fail_allocations(Campaign& campaign, Judge& judge, int times) {
  campaign.lab.prepare(judge.job());
  const unsigned long calls = campaign.lab.run(judge.job().arguments, {.fault = Fault{.call = "malloc"}}).calls;
  for (int i = 0; i < times; ++i) {
    const unsigned long at = i % 2 == 0 ? any_place(campaign, calls) : campaign.any(calls) + 1;
    const Fault fault{.call = "malloc", .at = at, .error = ENOMEM, .times = campaign.any(2)};
    Ended ended;
    const std::string complaint = judge.trial({.fault = fault}, {.statuses = {0, 3, 4, 5}}, ended);
    campaign.note("malloc", judge.job().name, fault.text(), ended, complaint);
  }
}

/// From what the program cannot even be loaded with (status 127, by the loader) to what it needs.
void limit_memory(Campaign& campaign, Judge& judge) {
  Ended ended;
  const double step = campaign.all ? 1.01 : 1.05;
  for (double bytes = 9e6; bytes < 4e9; bytes *= step) {
    const auto limit = static_cast<rlim_t>(bytes);
    std::string complaint = judge.trial({.address_space = limit}, {.statuses = {0, 3, 4, 5, 127}}, ended);
    if (ended.status == 127 && complaint == "it ends without a message") complaint.clear();
    campaign.note("memory", judge.job().name, std::to_string(limit) + " bytes", ended, complaint);
    if (ended.status == 0) return;
  }
}

/// Fewer threads do the same work.
void refuse_threads(Campaign& campaign, Judge& judge) {
  for (unsigned long at = 1; at <= 2; ++at) {
    const Fault fault{.call = "thread", .at = at, .error = EAGAIN, .times = 0};
    Ended ended;
    const std::string complaint = judge.trial({.fault = fault}, {.statuses = {0}}, ended);
    campaign.note("no threads", judge.job().name, fault.text(), ended,
                  ended.struck ? complaint : "the fault did not come");
  }
}

}  // namespace

void try_memory(Campaign& campaign) {
  for (const Job& job : campaign.jobs) {
    if (!campaign.wants("memory", job.name)) continue;
    Judge judge(campaign.lab, job);
    fail_allocations(campaign, judge, campaign.all ? 200 : 4);
    const bool is_typical = job.name == "threads" || job.name == "surface" || job.name == "queries";
    if (campaign.all || is_typical) limit_memory(campaign, judge);
    if (job.name == "threads") refuse_threads(campaign, judge);
  }
}

}  // namespace geodrome::faults
