// SPDX-License-Identifier: MIT
#include "tests/faults/judge.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <stdexcept>

namespace geodrome::faults {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::ranges::find(list, word) != list.end();
}

/// The number before " to compute" in what the program says on standard error.
std::uint64_t rows_to_compute(const std::string& text) {
  const std::size_t end = std::min(text.find(" rows to compute"), text.find(" row to compute"));
  if (end == std::string::npos) throw std::runtime_error("the program does not tell the rows to compute: " + text);
  return std::stoull(text.substr(text.rfind(' ', end - 1) + 1));
}

}  // namespace

std::uint64_t rows_on_record(const Files& files, const Job& job) {
  const auto found = files.find(job.outputs[0] + ".partial");
  if (found == files.end()) return 0;
  const std::string& partial = found->second;
  constexpr std::size_t trailer = 64, header = 128;
  if (partial.size() < header + trailer || partial.compare(partial.size() - trailer, 8, "GEODROME") != 0)
    return files.contains(job.outputs[0] + ".partial-footer") ? job.rows : 0;
  std::uint64_t numbers[3];  // version and bytes of an entry, rows, columns
  std::memcpy(numbers, partial.data() + partial.size() - trailer + 8, sizeof numbers);
  const std::size_t first = header + numbers[1] * numbers[2] * (numbers[0] >> 32);
  std::uint64_t count = 0, checksum = 0;
  for (std::uint64_t row = 0; row < job.rows; ++row) {
    std::memcpy(&checksum, partial.data() + first + row * sizeof checksum, sizeof checksum);
    count += checksum != 0;
  }
  return count;
}

Judge::Judge(Lab& lab, const Job& job) : lab_(lab), job_(job) {
  lab_.prepare(job_);
  const Ended ended = lab_.run(job_.arguments);
  const Files files = lab_.files();
  if (ended.status != 0) throw std::runtime_error(job.name + " fails without faults: " + ended.err);
  for (const std::string& name : job_.outputs) outputs_[name] = comparable(name, files.at(name));
  seconds_ = ended.seconds;
}

std::string Judge::complaint_of_outputs(const Files& files, const std::string& old, bool all) const {
  for (const auto& [name, whole] : outputs_) {
    const auto found = files.find(name);
    if (found == files.end()) {
      if (all) return name + " is missing";
      continue;
    }
    if (!all && !old.empty() && found->second == old) continue;
    try {
      const bool is_whole = comparable(name, found->second) == whole;
      if (!is_whole && (all || !job_.tells_failures)) return name + " holds something else";
    } catch (const std::exception&) {
      return name + " is half-written";
    }
  }
  return {};
}

std::string Judge::complaint_of_leftovers(const Files& files, bool done, const Expected& expected) const {
  for (const auto& [name, bytes] : files) {
    if (contains(job_.reads, name) || contains(job_.outputs, name)) continue;
    const bool goes_on = name.ends_with(".partial") || name.ends_with(".partial-footer");
    if (!done && job_.rows > 0 && goes_on) continue;
    if (expected.may_leave_footer && name.ends_with(".partial-footer")) continue;
    if (expected.may_be_killed &&
        (name.ends_with(".tmp") || name.ends_with(".partial-text") || name.ends_with("-lock")))
      continue;
    return name + " is left behind";
  }
  return {};
}

std::string Judge::complaint(const Ended& ended, const Expected& expected, const std::string& old) const {
  if (ended.status == Ended::hangs) return "it hangs";
  if (!expected.statuses.contains(ended.status)) return "its status is " + std::to_string(ended.status);
  if (ended.err.find(expected.warning) == std::string::npos) return "it does not warn: " + expected.warning;
  const Files files = lab_.files();
  const bool done = ended.status == 0;
  if (const std::string text = complaint_of_outputs(files, old, done); !text.empty()) return text;
  if (const std::string text = complaint_of_leftovers(files, done, expected); !text.empty()) return text;
  if (done || ended.status > 128) return {};
  if (job_.tells_failures && files.contains(job_.outputs[0])) return {};
  for (const std::string& word : expected.words)
    if (ended.err.find(word) == std::string::npos) return "its message does not say '" + word + "'";
  return ended.err.find("geodrome: ") == std::string::npos ? "it ends without a message" : "";
}

std::string Judge::complaint_of_second_run() const {
  const Files left = lab_.files();
  std::vector<std::string> arguments = job_.arguments;
  if (job_.rows > 0 && !contains(arguments, "--resume")) arguments.push_back("--resume");
  const Ended ended = lab_.run(arguments);
  if (ended.status != 0) return "run again, it ends with " + std::to_string(ended.status) + ": " + ended.err;
  if (const std::string text = complaint_of_outputs(lab_.files(), {}, true); !text.empty()) return "run again: " + text;
  if (job_.rows == 0) return {};
  const std::uint64_t there = rows_on_record(left, job_), computed = rows_to_compute(ended.err);
  if (computed + there <= job_.rows) return {};
  return "run again, it computes " + std::to_string(computed) + " rows though " + std::to_string(there) + " of " +
         std::to_string(job_.rows) + " are on record";
}

std::string Judge::trial(const Conditions& conditions, const Expected& expected, Ended& ended, const std::string& old) {
  lab_.prepare(job_, old);
  ended = lab_.run(job_.arguments, conditions);
  const std::string text = complaint(ended, expected, old);
  return text.empty() && ended.status != 0 ? complaint_of_second_run() : text;
}

}  // namespace geodrome::faults
