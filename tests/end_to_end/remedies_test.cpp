// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;

/// What users of the program are told to do is told in its flags; the engine's own tests see the members.
class Remedies : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "m.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
    write_bytes(folder_ / "twins.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 0\n1 1 0\n3 0 1 2\n3 4 5 3\n");
    write_bytes(folder_ / "hole.xyz", "0 0 0\n1 nan 0\n0 1 0\n");
    write_bytes(folder_ / "hole.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
    write_bytes(folder_ / "flat.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n");
    write_bytes(folder_ / "pairs.txt", "0, 1\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  Outcome run(const std::string& command, const std::string& input, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{command, file(input)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    Outcome outcome = run_geodrome(folder_, arguments);
    EXPECT_EQ(outcome.err.find('`'), std::string::npos) << "a member is named: " << outcome.err;
    return outcome;
  }

  void expect(const std::string& remedy, const std::string& command, const std::string& input,
              const std::vector<std::string>& options) {
    const Outcome outcome = run(command, input, options);
    EXPECT_NE(outcome.err.find("; " + remedy), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Remedies, OfOutputsNameTheirOptions) {
  expect("name an output: -o FILE or --nearest FILE\n", "distances", "m.off", {});
  expect("name it with -o FILE\n", "distances", "m.off", {"--nearest", file("n.csv"), "--resume"});
  write_bytes(folder_ / "d.npy.partial", "no matrix");
  expect("remove it, or rerun without --resume to start anew\n", "distances", "m.off",
         {"-o", file("d.npy"), "--resume"});
}

TEST_F(Remedies, OfQueryRulesNameQuery) {
  expect("leave --query out\n", "distances", "m.off", {"--nearest", file("n.csv"), "--query", "insert"});
  expect("leave --query out, or take the vertices as points with --as points\n", "distances", "m.off",
         {"-o", file("d.npy"), "--query", "insert"});
}

TEST_F(Remedies, OfInputsNameTheOptionsOfReading) {
  expect("use --drop-nonfinite to leave such points out\n", "check", "hole.xyz", {});
  expect("repair the mesh, or use --as points --drop-nonfinite\n", "check", "hole.off", {});
  expect("use --as points to take its vertices\n", "check", "flat.off", {});
  expect("use --as points\n", "check", "hole.xyz", {"--as", "mesh"});
}

TEST_F(Remedies, StandInTheAnswerForPrograms) {
  const Outcome outcome = run("check", "hole.xyz", {"--json"});
  EXPECT_NE(outcome.out.find("\"remedy\": \"use --drop-nonfinite"), std::string::npos) << outcome.out;
}

TEST_F(Remedies, StandInReportsAsTheLibrarySaysThemWithTheirCode) {
  const std::string json = run("check", "twins.off", {"--json"}).out;
  EXPECT_NE(json.find("\"remedy\": \"set `read.weld` to merge them\""), std::string::npos) << json;
  EXPECT_NE(json.find("\"remedy_code\": \"read.weld\""), std::string::npos) << json;
}

TEST_F(Remedies, OfWarningsNameTheOptionsOfReading) {
  expect("use --weld to merge them\n", "path", "twins.off", {"--from", "0", "--to", "1", "-o", file("p.csv")});
  EXPECT_NE(run("check", "twins.off", {}).out.find("; use --weld to merge them\n"), std::string::npos);
  expect("use --as points to take its vertices\n", "surface", "m.off", {"--tangent", "pca", "-o", file("s.off")});
}

TEST_F(Remedies, OfChoicesNameTheOptionsOfCompare) {
  const std::string both = "solver=cgal,chen_han";
  expect("write --stage STAGE=A,B[:k=v,...], e.g. --stage solver=chen_han,cgal\n", "compare", "m.off",
         {"--stage", "solver"});
  expect("vary the solver, or say --as points to take the vertices as a sample\n", "compare", "m.off",
         {"--stage", "tangent=jet"});
  expect("name all choices in --stage\n", "compare", "m.off", {"--solver", "cgal", "--stage", both});
}

TEST_F(Remedies, OfSolversNameTheCommandThatTells) {
  write_bytes(folder_ / "book.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  expect("repair the mesh, or choose a solver that needs less ('geodrome plugins show NAME' tells)\n", "distances",
         "book.off", {"-o", file("d.npy"), "--solver", "cgal"});
  expect("say --solver with one that does (aleksandrov", "queries", "m.off",
         {"--pairs", file("pairs.txt"), "-o", file("p.csv"), "--solver", "chen_han"});
}

}  // namespace
