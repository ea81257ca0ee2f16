// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cstring>

#include "tests/faults/campaign.hpp"

namespace geodrome::faults {

namespace {

/// Ways in which a call may go wrong.
struct Failing {
  const char* call;
  std::vector<int> errors;
  std::vector<long> shortened = {};  ///< in bytes
};

// What open, write and so on may give by their manual pages, and file systems do give.
const Failing failing[] = {
    {"open", {EACCES, EMFILE, EIO}},
    {"create", {EACCES, EMFILE, ENOSPC, EROFS}},
    {"read", {EIO, EINTR}, {1}},
    {"pread", {EIO, EINTR}, {7}},
    {"write", {ENOSPC, EIO, EDQUOT, EINTR}, {1000, 0}},
    {"pwrite", {ENOSPC, EIO, EDQUOT, EINTR}, {7, 0}},
    {"fsync", {EIO, ENOSPC, EINTR}},
    {"close", {EIO, ENOSPC}},
    {"ftruncate", {EIO, EFBIG, EINTR}},
    {"fallocate", {ENOSPC, EIO, EOPNOTSUPP, ENOSYS, EINTR}},
    {"flock", {ENOLCK, EOPNOTSUPP, ENOSYS, EIO, EINTR}},
    {"rename", {EACCES, EIO, ENOSPC}},
    {"unlink", {EACCES, EIO}},
    {"stat", {EIO, EACCES}},
    {"fstat", {EIO}},
};

/// Errors that are to be told in the system's words. Others are carried on after, or have words of their own.
bool is_told(const Fault& fault) {
  return fault.shortened < 0 && fault.error != EINTR && fault.call != "fallocate" && fault.call != "flock";
}

/// A refusal is the end of a job that the disk has no room for. A file system without locks is told and used all the
/// same.
Expected expected_of(const Fault& fault) {
  Expected expected;
  expected.may_leave_footer = fault.call == "unlink";
  if (fault.call == "fallocate") expected.statuses = {0, 3, 4};
  const bool no_locks = fault.call == "flock" && fault.error != EIO && fault.error != EINTR;
  if (no_locks) expected.statuses = {0}, expected.warning = "cannot be locked";
  if (is_told(fault)) expected.words = {std::strerror(fault.error)};
  return expected;
}

void try_once(Campaign& campaign, Judge& judge, const Fault& fault) {
  Ended ended;
  // An index that is there is read, and not overwritten; files that are there change how many are examined.
  const bool may_be_old = judge.job().name != "queries" && fault.call != "stat";
  const std::string old = may_be_old && campaign.any(2) == 0 ? "what was here\n" : "";
  const std::string complaint = judge.trial({.fault = fault}, expected_of(fault), ended, old);
  campaign.note("calls." + fault.call, judge.job().name, fault.text() + (old.empty() ? "" : ", old outputs there"),
                ended, ended.struck ? complaint : "the fault did not come");
}

/// Every way of one call, at one place.
void try_place(Campaign& campaign, Judge& judge, const Failing& way, unsigned long at) {
  std::vector<Fault> faults;
  for (const int error : way.errors) {
    faults.push_back({.call = way.call, .at = at, .error = error});
    if (error != EINTR) faults.push_back({.call = way.call, .at = at, .error = error, .times = 0});
  }
  for (const long bytes : way.shortened) faults.push_back({.call = way.call, .at = at, .shortened = bytes});
  if (campaign.all)
    for (const Fault& fault : faults) try_once(campaign, judge, fault);
  else
    try_once(campaign, judge, faults[campaign.any(faults.size())]);
}

}  // namespace

void try_calls(Campaign& campaign) {
  for (const Job& job : campaign.jobs) {
    std::optional<Judge> judge;
    for (const Failing& way : failing) {
      if (!campaign.wants("calls." + std::string(way.call), job.name)) continue;
      if (!judge) judge.emplace(campaign.lab, job);
      campaign.lab.prepare(job);
      const unsigned long calls = campaign.lab.run(job.arguments, {.fault = Fault{.call = way.call}}).calls;
      // The suite tries a seeded few of many; rows of a matrix are alike.
      const unsigned long most = campaign.all ? 20 : 2;
      for (unsigned long i = 0; i < std::min(calls, most); ++i)
        try_place(campaign, *judge, way, calls <= most ? i + 1 : campaign.any(calls) + 1);
    }
  }
}

}  // namespace geodrome::faults
