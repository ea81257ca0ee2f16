// SPDX-License-Identifier: MIT
// The conformance kit finds each planted fault, says where, and finds none in the same solver without one.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string_view>

#include "geodrome/abi.hpp"
#include "geodrome/conformance.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::conformance {
namespace {

constexpr bool memory_is_judged = std::string_view(GEODROME_SANITIZER) == "plain";
constexpr const char* not_judged = "sanitizers count memory in their own way, and cannot run in a little of it";

Subject faulty(const std::string& fault) {
  return find_subject(GEODROME_BINARY_DIR "/tests/faulty_solvers/solver_faulty_" + fault + ".so");
}

struct Planted {
  const char* fault;
  std::vector<const char*> found_by;  ///< demands that must fail
  const char* words;                  ///< in what the first of them found or expected
  std::vector<const char*> sparing;   ///< demands that have nothing to do with the fault and must hold
};

std::ostream& operator<<(std::ostream& out, const Planted& planted) { return out << planted.fault; }

class FaultySolver : public ::testing::TestWithParam<Planted> {};

TEST_P(FaultySolver, IsFound) {
  const Planted& planted = GetParam();
  if (!memory_is_judged && planted.fault == std::string_view("leaks")) GTEST_SKIP() << not_judged;
  const Subject subject = faulty(planted.fault);
  for (const char* demand : planted.found_by) {
    const Verdict verdict = judge_in_child(subject, demand, {.seconds = 20});
    EXPECT_EQ(verdict.outcome, Outcome::failed) << demand;
    EXPECT_FALSE(verdict.expected.empty()) << demand;
    if (demand == planted.found_by.front()) {
      EXPECT_NE((verdict.expected + " / " + verdict.found).find(planted.words), std::string::npos)
          << verdict.expected << " / " << verdict.found;
    }
  }
  for (const char* demand : planted.sparing)
    EXPECT_EQ(judge_in_child(subject, demand).outcome, Outcome::held) << demand;
}

const Planted planted_faults[] = {
    {"a_millionth",
     {"distances.cube", "guarantee.shapes", "surfaces.audit_rough"},
     "1.0000009",
     {"surfaces.components"}},
    {"single_precision",
     {"distances.plane", "guarantee.shapes", "invariances.scale"},
     "1.41421353",
     {"requests.source"}},
    {"zero_unreachable", {"surfaces.components", "surfaces.loose_vertices"}, "inf / 0", {"distances.plane"}},
    {"ignores_boundary", {"distances.hole", "distances.prism", "guarantee.shapes"}, "at least", {"distances.cube"}},
    {"shares_results",
     {"discipline.two_searches", "discipline.two_threads"},
     "stays what it is",
     {"discipline.used_again"}},
    {"hangs", {"surfaces.no_area"}, "still running after 20 s", {"distances.plane"}},
    {"crashes", {"surfaces.three_faces", "surfaces.bow_tie"}, "SIGSEGV", {"distances.plane"}},
    {"counter_names", {"discipline.counter_names"}, "snake case", {"discipline.bytes"}},
    {"leaks", {"discipline.memory_searches", "discipline.memory_surfaces"}, "at most", {"distances.plane"}},
    {"guesses_in_faces", {"distances.plane_any_point", "guarantee.shapes"}, "at most", {"distances.plane"}},
    {"several_sources", {"requests.many_sources", "sources.in_one_face"}, "at most", {"requests.source"}},
    {"several_in_a_face", {"sources.in_one_face"}, "at most", {"requests.many_sources", "requests.start_distance"}},
    {"late_starts", {"sources.with_starts"}, "at most", {"requests.many_sources", "sources.in_one_face"}},
    {"long_bounds", {"bounds.vertices", "bounds.points"}, "at most", {"guarantee.shapes", "requests.radius"}},
    {"bounds_beyond", {"bounds.limits"}, "at most", {"bounds.vertices", "bounds.points"}},
    {"planned_long",
     {"together.meshes", "together.requests", "together.other_plans", "together.paths"},
     "within",
     {"guarantee.shapes"}},
    {"planned_sources", {"together.requests"}, "within", {"together.meshes", "together.bytes"}},
    {"planned_by_threads", {"together.threads"}, "0", {"together.cancelled"}},
    {"short_paths",
     {"paths.lead_to_sources", "paths.lead_into_faces", "surfaces.audit_flat"},
     "within",
     {"distances.plane"}},
};

INSTANTIATE_TEST_SUITE_P(Planted, FaultySolver, ::testing::ValuesIn(planted_faults),
                         [](const auto& info) { return std::string(info.param.fault); });

TEST(FaultySolvers, WithoutAFaultFailNothing) {
  const Subject subject = faulty("none");
  std::size_t held = 0;
  for (const Demand& demand : demands("solver")) {
    const Verdict verdict = judge_in_child(subject, demand.name);
    EXPECT_NE(verdict.outcome, Outcome::failed) << demand.name << ": " << verdict.expected << " / " << verdict.found;
    held += verdict.outcome == Outcome::held;
  }
  EXPECT_GT(held, 60u);
}

TEST(ConformanceKit, NamesEveryDemandOnce) {
  for (const char* stage : {"tangent", "control", "decimator", "reconstructor", "solver"}) {
    std::vector<std::string> names;
    for (const Demand& demand : demands(stage)) {
      names.push_back(demand.name);
      EXPECT_FALSE(demand.sentence.empty()) << demand.name;
    }
    EXPECT_FALSE(names.empty()) << stage;
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << stage;
  }
  EXPECT_THROW(demands("furnace"), OptionError);
}

TEST(ConformanceKit, LimitsMemory) {
  if (!memory_is_judged) GTEST_SKIP() << not_judged;
  const Verdict verdict = judge_in_child(faulty("none"), "guarantee.hostile", {.megabytes = 1});
  EXPECT_EQ(verdict.outcome, Outcome::failed);
}

TEST(ConformanceKit, JudgesAPluginWithOptions) {
  Subject subject = find_subject("aleksandrov:delta=0.3");
  EXPECT_EQ(subject.options, "delta=0.3");
  EXPECT_EQ(judge_in_child(subject, "distances.cube").outcome, Outcome::held);
  subject.options = "delta=0";
  EXPECT_EQ(judge_in_child(subject, "distances.cube").outcome, Outcome::failed);
}

/// Without a factor, but with lower bounds: what both demand beside each other.
TEST(ConformanceKit, FindsNothingInTheMiddleOfIntervals) {
  const Subject subject = find_subject("merged_windows:value=middle");
  std::size_t held = 0;
  for (const Demand& demand : demands("solver")) {
    const Verdict verdict = judge_in_child(subject, demand.name);
    EXPECT_NE(verdict.outcome, Outcome::failed) << demand.name << ": " << verdict.expected << " / " << verdict.found;
    held += verdict.outcome == Outcome::held;
  }
  EXPECT_GT(held, 55u);
}

TEST(ConformanceKit, FindsNothingInSearchesThatArePreparedTogether) {
  Subject subject = find_subject(GEODROME_BINARY_DIR "/tests/sound_plugins/solver_test_together.so");
  const testing::TemporaryFolder folder;
  subject.meshes = {folder / "m.off"};
  std::ofstream(subject.meshes[0]) << "OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n3 0 2 3\n";
  std::size_t held = 0;
  for (const Demand& demand : demands("solver")) {
    if (!demand.name.starts_with("together.")) continue;
    const Verdict verdict = judge_in_child(subject, demand.name);
    EXPECT_EQ(verdict.outcome, Outcome::held) << demand.name << ": " << verdict.expected << " / " << verdict.found;
    ++held;
  }
  EXPECT_EQ(held, 9u);
}

TEST(ConformanceKit, RefusesUnknownNames) {
  EXPECT_THROW(find_subject("nobody"), OptionError);
  EXPECT_THROW(judge(find_subject("chen_han"), "distances.nowhere"), OptionError);
  EXPECT_THROW(judge_in_child(find_subject("chen_han"), "distances.nowhere"), OptionError);
}

}  // namespace
}  // namespace geodrome::conformance
