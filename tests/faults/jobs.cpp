// SPDX-License-Identifier: MIT
#include "tests/faults/jobs.hpp"

#include <algorithm>
#include <cerrno>
#include <stdexcept>

namespace geodrome::faults {

namespace {

using Words = std::vector<std::string>;

Words plus(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The numbers 0 to count - 1 as a list.
std::string rows_up_to(int count, const char* separator) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : separator) + std::to_string(i);
  return text;
}

constexpr int few_rows = 12;

Words few_sources() { return {"--sources", rows_up_to(few_rows, ","), "--threads", "1"}; }

void make_inputs(Lab& lab) {
  lab.make("m.ply", {"shape", "bumpy", "--mesh", "--faces", "300", "-o", "%m.ply"});
  lab.make("t.xyz", {"shape", "sphere", "--points", "200", "-o", "%t.xyz"});
  lab.make("other.ply", {"shape", "plane", "--mesh", "--faces", "300", "-o", "%other.ply"});
  lab.make("other.xyz", {"shape", "torus", "--points", "300", "-o", "%other.xyz"});
  lab.add("list.txt", rows_up_to(few_rows, "\n"));
  lab.add("pairs.txt", "0, 1\n5, 17\n3, 160\n0.5 0.5 0.5, 9\n");
  std::string weights;
  for (int face = 0; face < 320; ++face) weights += std::to_string(1 + face % 3) + "\n";
  lab.add("w.txt", weights);
  lab.make("truth.npy", {"distances", "%m.ply", "-o", "%truth.npy", "--quiet"});
}

/// The matrix job as a fault left it: the files of an unfinished matrix.
Files left_by(Lab& lab, const Job& job, const Fault& fault) {
  lab.prepare(job);
  if (lab.run(job.arguments, {.fault = fault}).status == 0) throw std::runtime_error("no unfinished matrix is left");
  Files left;
  for (const auto& [name, bytes] : lab.files())
    if (name.find(".partial") != std::string::npos) left[name] = bytes;
  return left;
}

/// Jobs of one matrix: from nothing, on several threads, as text, half done, all but published.
void add_matrices(std::vector<Job>& jobs, Lab& lab) {
  const Words start{"distances", "%m.ply"};
  const Words npy = plus(plus(start, {"-o", "%d.npy"}), few_sources());
  jobs.push_back({"matrix",
                  plus(npy, {"--report", "%r.json", "--surface", "%s.ply"}),
                  {"m.ply"},
                  {"d.npy", "r.json", "s.ply"},
                  few_rows});
  jobs.push_back({"threads", plus(start, {"-o", "%d.npy", "--threads", "3"}), {"m.ply"}, {"d.npy"}, 162});
  jobs.push_back({"csv", plus(plus(start, {"-o", "%d.csv"}), few_sources()), {"m.ply"}, {"d.csv"}, few_rows});
  Job half{"resume", plus(npy, {"--resume"}), {"m.ply"}, {"d.npy"}, few_rows}, whole = half;
  half.before = left_by(lab, half, {.call = "pwrite", .at = few_rows, .error = EIO, .times = 0});
  whole.name = "publish";
  whole.before = left_by(lab, whole, {.call = "rename", .path = "d.npy", .at = 1, .error = EIO});
  jobs.push_back(half);
  jobs.push_back(whole);
}

}  // namespace

std::vector<Job> make_jobs(Lab& lab) {
  make_inputs(lab);
  std::vector<Job> jobs;
  add_matrices(jobs, lab);
  const std::string oracle = "aleksandrov:delta=0.5";
  jobs.push_back({"nearest",
                  {"distances", "%m.ply", "--sources", "@%list.txt", "--nearest", "%n.csv", "--weights", "%w.txt",
                   "--solver", oracle, "--report", "%r.json"},
                  {"m.ply", "list.txt", "w.txt"},
                  {"n.csv", "r.json"}});
  const Words queries{"queries", "%m.ply",   "--pairs", "%pairs.txt", "--solver", oracle,
                      "--index", "%i.index", "-o",      "%q.csv",     "--report", "%r.json"};
  jobs.push_back({"queries", queries, {"m.ply", "pairs.txt"}, {"q.csv", "i.index", "r.json"}});
  lab.prepare(jobs.back());
  lab.make("i.index", queries);
  jobs.push_back(
      {"index",
       {"queries", "%m.ply", "--pairs", "%pairs.txt", "--solver", oracle, "--index", "%i.index", "-o", "%q.npy"},
       {"m.ply", "pairs.txt", "i.index"},
       {"q.npy"}});
  jobs.push_back({"surface", {"surface", "%t.xyz", "-o", "%s.off"}, {"t.xyz"}, {"s.off"}});
  jobs.push_back({"path", {"path", "%m.ply", "--from", "0", "--to", "5", "-o", "%p.obj"}, {"m.ply"}, {"p.obj"}});
  jobs.push_back({"compare",
                  {"compare", "%m.ply", "--stage", "solver=chen_han,edge_dijkstra", "--sources", "0,1", "--truth",
                   "%truth.npy", "-o", "%c.json"},
                  {"m.ply", "truth.npy"},
                  {"c.json"}});
  jobs.back().tells_failures = true;
  jobs.push_back({"shape", {"shape", "bumpy", "--mesh", "--faces", "100", "-o", "%x.off"}, {}, {"x.off"}});
  return jobs;
}

const Job& job_named(const std::vector<Job>& jobs, const std::string& name) {
  const auto found = std::ranges::find(jobs, name, &Job::name);
  if (found == jobs.end()) throw std::runtime_error("there is no job " + name);
  return *found;
}

}  // namespace geodrome::faults
