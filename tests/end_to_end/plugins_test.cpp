// SPDX-License-Identifier: MIT
// `geodrome plugins check` and `geodrome plugins new`, as their users meet them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

std::string faulty(const std::string& fault) {
  return GEODROME_BINARY_DIR "/tests/faulty_solvers/solver_faulty_" + fault + ".so";
}

class PluginsCommand : public ::testing::Test {
 protected:
  Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "plugins");
    return run_geodrome(folder_, arguments);
  }
  TemporaryFolder folder_;
};

TEST_F(PluginsCommand, CheckPassesAGoodPlugin) {
  const Outcome outcome = run({"check", "chen_han", "--only", "distances"});
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("held    distances.cube"), std::string::npos);
  EXPECT_NE(outcome.out.find(" held, 0 failed, "), std::string::npos);
}

TEST_F(PluginsCommand, CheckFailsAFaultyOneWithStatus4) {
  const Outcome outcome = run({"check", faulty("zero_unreachable"), "--only", "surfaces.components"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.out.find("FAILED  surfaces.components"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("expected  inf"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("found     0"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("0 held, 1 failed"), std::string::npos) << outcome.out;
}

TEST_F(PluginsCommand, CheckAsJsonTellsEachVerdict) {
  const Outcome outcome = run({"check", faulty("short_paths"), "--only", "paths", "--json"});
  EXPECT_EQ(outcome.status, 4);
  const json answer = json::parse(outcome.out);
  EXPECT_EQ(answer["plugin"]["name"], "faulty_short_paths");
  EXPECT_EQ(answer["failed"], 2);
  ASSERT_EQ(answer["verdicts"].size(), 4u);
  for (const json& verdict : answer["verdicts"]) {
    const bool failed = verdict["outcome"] == "failed";
    EXPECT_EQ(failed, verdict.contains("expected")) << verdict;
    EXPECT_EQ(failed, verdict.contains("found")) << verdict;
    EXPECT_GE(verdict["seconds"], 0) << verdict;
  }
}

TEST_F(PluginsCommand, CheckEndsAPluginThatHangs) {
  const Outcome outcome = run({"check", faulty("hangs"), "--only", "surfaces.no_area", "--timeout", "2"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_NE(outcome.out.find("still running after 2 s"), std::string::npos) << outcome.out;
}

TEST_F(PluginsCommand, CheckJudgesOnGivenMeshes) {
  write_bytes(folder_ / "m.off", "OFF\n4 2 0\n0 0 0\n3 0 0\n3 4 0\n0 4 1\n3 0 1 2\n3 0 2 3\n");
  const std::string mesh = (folder_ / "m.off").string();
  EXPECT_EQ(run({"check", "schreiber", "--only", "guarantee.given", "--mesh", mesh}).status, 0);
  EXPECT_EQ(run({"check", faulty("a_millionth"), "--only", "guarantee.given", "--mesh", mesh}).status, 4);
}

TEST_F(PluginsCommand, CheckRefusesWhatIsNoPluginOrNoDemand) {
  EXPECT_EQ(run({"check", "nobody"}).status, 2);
  EXPECT_EQ(run({"check", "chen_han", "--only", "nothing"}).status, 2);
  EXPECT_EQ(run({"check", GEODROME_BINARY_DIR "/tests/bad_plugins/solver_bad_crashes_at_load.so"}).status, 5);
}

TEST_F(PluginsCommand, NewWritesAProjectOfEachStageThatIsNamedThroughout) {
  const std::pair<std::string, std::string> stages[] = {{"tangent", "TangentEstimator"},
                                                        {"control", "ControlFunction"},
                                                        {"decimator", "Decimator"},
                                                        {"reconstructor", "SurfaceReconstructor"},
                                                        {"solver", "ShortestPathSolver"}};
  for (const auto& [stage, interface] : stages) {
    const std::string folder = (folder_ / stage).string();
    const Outcome outcome = run({"new", "my_own", "--stage", stage, "-o", folder});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* name : {"CMakeLists.txt", "README.md", "contract_test.cpp", "my_own.cpp"}) {
      const std::string text = read_bytes(folder_ / stage / name);
      EXPECT_FALSE(text.empty()) << name;
      for (const char* placeholder : {"template_name", "TemplateName", "template_stage"})
        EXPECT_EQ(text.find(placeholder), std::string::npos) << stage << ", " << name;
    }
    const std::string source = read_bytes(folder_ / stage / "my_own.cpp");
    EXPECT_NE(source.find("class MyOwn : public " + interface), std::string::npos) << stage;
  }
}

TEST_F(PluginsCommand, NewOverwritesNothing) {
  const std::string folder = (folder_ / "mine").string();
  std::filesystem::create_directory(folder);
  EXPECT_EQ(run({"new", "mine", "--stage", "solver", "-o", folder}).status, 3);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(PluginsCommand, NewRefusesNamesThatCannotBe) {
  const std::string folder = (folder_ / "mine").string();
  for (const char* name : {"Mine", "2nd", "my-own", "a/b", ""})
    EXPECT_EQ(run({"new", name, "--stage", "solver", "-o", folder}).status, 2) << name;
  EXPECT_EQ(run({"new", "mine", "--stage", "furnace", "-o", folder}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

}  // namespace
