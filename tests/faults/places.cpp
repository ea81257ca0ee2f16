// SPDX-License-Identifier: MIT
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "tests/faults/campaign.hpp"
#include "tests/faults/jobs.hpp"
#include "tests/support/program.hpp"

namespace geodrome::faults {

namespace {

/// The message itself goes to a file, which has to have room for it.
void limit_files(Campaign& campaign, Judge& judge) {
  const double step = campaign.all ? 1.1 : 2.5;
  Ended ended{.status = 1};
  for (double bytes = 1000; ended.status != 0; bytes *= step) {
    const auto limit = static_cast<rlim_t>(bytes);
    const std::string complaint =
        judge.trial({.file_size = limit}, {.statuses = {0, 3}, .words = {std::strerror(EFBIG)}}, ended);
    campaign.note("file size", judge.job().name, std::to_string(limit) + " bytes", ended, complaint);
  }
}

/// Where there are no locks, the file that stands for one is respected.
void find_lock_file(Campaign& campaign, const Job& job) {
  campaign.lab.prepare(job);
  const std::string name = job.outputs[0] + ".partial-lock";
  testing::write_bytes(campaign.lab.path(name), "process 7 on another machine");
  const Fault fault{.call = "flock", .at = 1, .error = ENOSYS};
  const Ended ended = campaign.lab.run(job.arguments, {.fault = fault});
  std::string complaint;
  if (ended.status != 4 || ended.err.find(name + " is there: process 7 on another machine") == std::string::npos)
    complaint = "it does not name who writes";
  if (!campaign.lab.files().contains(name)) complaint = "it removed what is not its own";
  campaign.note("lock file", job.name, "of another machine", ended, complaint);
}

/// Where the result cannot be told, the files are whole all the same, as the message says.
void lose_standard_output(Campaign& campaign, Judge& judge) {
  for (const char* out : {"/dev/full", "closed"}) {
    const Expected expected{.statuses = {3}, .words = {"standard output cannot be written"}};
    Ended ended;
    std::string complaint = judge.trial({.out = out}, expected, ended);
    if (complaint.empty()) complaint = judge.complaint_of_outputs(campaign.lab.files(), {}, true);
    campaign.note("no output", judge.job().name, out, ended, complaint);
  }
}

/// A small file system in memory; only root may make one.
class SmallDisk {
 public:
  SmallDisk() : mounted_(mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=2m") == 0) {}
  ~SmallDisk() {
    if (mounted_) umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_there() const { return mounted_; }
  std::string path() const { return folder_.path().string(); }
  void set_read_only(bool on) const {
    mount("tmpfs", folder_.path().c_str(), "tmpfs", MS_REMOUNT | (on ? MS_RDONLY : 0), nullptr);
  }
  /// Leaves so much room, in bytes.
  void fill_up_to(std::uint64_t room) const {
    empty();
    const std::uint64_t available = std::filesystem::space(folder_.path()).available;
    testing::write_bytes(folder_ / "ballast", std::string(available - std::min(available, room), 'x'));
  }
  void empty() const { std::filesystem::remove(folder_ / "ballast"); }

 private:
  testing::TemporaryFolder folder_;
  bool mounted_;
};

void fill_disk(Campaign& campaign, const SmallDisk& disk, Lab& lab, Judge& judge) {
  const Job& job = judge.job();
  const std::uint64_t step = campaign.all ? 4096 : 32768;
  Ended ended{.status = 1};
  for (std::uint64_t room = 0; ended.status != 0; room += step) {
    lab.prepare(job);
    disk.fill_up_to(room);
    ended = lab.run(job.arguments);
    disk.empty();
    std::string complaint = judge.complaint(ended, {.statuses = {0, 3, 4}});
    if (complaint.empty() && ended.status != 0) complaint = judge.complaint_of_second_run();
    campaign.note("full disk", job.name, std::to_string(room) + " bytes left", ended, complaint);
  }
}

void forbid_writing(Campaign& campaign, const SmallDisk& disk, Lab& lab, Judge& judge) {
  const Job& job = judge.job();
  lab.prepare(job);
  disk.set_read_only(true);
  const Ended ended = lab.run(job.arguments);
  disk.set_read_only(false);
  const Expected expected{.statuses = {3}, .words = {std::strerror(EROFS)}};
  std::string complaint = judge.complaint(ended, expected);
  if (complaint.empty()) complaint = judge.complaint_of_second_run();
  campaign.note("read-only", job.name, "the folder", ended, complaint);
}

}  // namespace

void try_places(Campaign& campaign) {
  for (const Job& job : campaign.jobs) {
    if (!campaign.wants("places", job.name)) continue;
    Judge judge(campaign.lab, job);
    limit_files(campaign, judge);
    lose_standard_output(campaign, judge);
    if (job.rows > 0) find_lock_file(campaign, job);
  }
  const SmallDisk disk;
  if (!disk.is_there()) {
    std::printf("skipped: a full and a read-only disk (%s)\n", std::strerror(errno));
    return;
  }
  Lab lab(campaign.lab.program(), disk.path());
  for (const Job& job : make_jobs(lab)) {
    if (!campaign.wants("places.disks", job.name)) continue;
    Judge judge(lab, job);
    fill_disk(campaign, disk, lab, judge);
    forbid_writing(campaign, disk, lab, judge);
  }
}

}  // namespace geodrome::faults
