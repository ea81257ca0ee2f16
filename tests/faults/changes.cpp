// SPDX-License-Identifier: MIT
#include "tests/faults/campaign.hpp"
#include "tests/support/program.hpp"

namespace geodrome::faults {

namespace {

/// Another content of the same format, with which the job would give something else.
std::string other_content(const Campaign& campaign, const std::string& name) {
  if (name.ends_with(".ply")) return campaign.lab.input("other.ply");
  if (name.ends_with(".xyz")) return campaign.lab.input("other.xyz");
  std::string bytes = campaign.lab.input(name);
  if (name.ends_with(".txt")) return bytes.substr(0, bytes.find('\n') + 1);
  bytes.back() ^= 1;
  return bytes;
}

/// A file that is replaced goes on being read as it was. One that is written to is found out: nothing is made of a
/// mixture.
void try_change(Campaign& campaign, const Judge& judge, const Fault& fault) {
  const Job& job = judge.job();
  campaign.lab.prepare(job);
  testing::write_bytes(campaign.lab.path(fault.path + ".new"), other_content(campaign, fault.path));
  const Ended ended = campaign.lab.run(job.arguments, {.fault = fault});
  std::filesystem::remove(campaign.lab.path(fault.path + ".new"));
  Expected expected{.statuses = {fault.act == "replace" ? 0 : 3},
                    .words = {fault.path, "was changed while it was read"}};
  campaign.note("changes", job.name, fault.text(), ended,
                ended.struck ? judge.complaint(ended, expected) : "the fault did not come");
}

}  // namespace

void try_changes(Campaign& campaign) {
  for (const Job& job : campaign.jobs) {
    if (!campaign.wants("changes", job.name)) continue;
    const Judge judge(campaign.lab, job);
    for (const std::string& file : job.reads)
      for (const char* call : {"read", "pread"}) {
        campaign.lab.prepare(job);
        const unsigned long calls = campaign.lab.run(job.arguments, {.fault = Fault{.call = call, .path = file}}).calls;
        for (unsigned long at = 1; at <= calls; ++at)
          for (const char* act : {"truncate", "grow", "rewrite", "replace"})
            if (campaign.all || campaign.any(4) == 0)
              try_change(campaign, judge, {.call = call, .path = file, .at = at, .act = act});
      }
  }
}

}  // namespace geodrome::faults
