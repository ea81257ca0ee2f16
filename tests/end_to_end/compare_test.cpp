// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

/// `geodrome compare` on the surface of the cube [-1, 1]^3, whose distances follow from unfolding, and on a torus.
class Compare : public ::testing::Test {
 protected:
  Compare() {
    write_bytes(folder_ / "cube.off",
                "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
                "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// A sample of 600 points.
  std::string sample(const std::string& shape) {
    const auto made = run_geodrome(folder_, {"shape", shape, "--points", "600", "-o", file(shape + ".xyz")});
    EXPECT_EQ(made.status, 0) << made.err;
    return file(shape + ".xyz");
  }
  std::string torus() { return sample("torus"); }
  Outcome run(const std::string& input, std::vector<std::string> more) {
    more.insert(more.begin(), {"compare", input});
    return run_geodrome(folder_, more);
  }
  Outcome cube(const std::vector<std::string>& more) { return run(file("cube.off"), more); }
  /// The figures of a comparison that ends with `status`.
  json figures(const std::string& input, std::vector<std::string> more, int status = 0) {
    more.push_back("--json");
    const Outcome outcome = run(input, more);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return json::parse(outcome.out);
  }
  json cube_figures(const std::vector<std::string>& more, int status = 0) {
    return figures(file("cube.off"), more, status);
  }
  void expect(const Outcome& outcome, int status, const std::string& word) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  }
  /// The true distances from corner 0 of the cube: one edge, one face's diagonal (over its edges or unfolded), or over
  /// two faces.
  static std::vector<double> from_corner() {
    const double edge = 2, diagonal = std::sqrt(8.0), opposite = std::sqrt(20.0);
    return {0, edge, diagonal, edge, edge, diagonal, opposite, diagonal};
  }
  void write_npy(const std::string& name, const std::string& shape, const std::vector<double>& values) {
    const std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }\n";
    std::string bytes = std::string("\x93NUMPY\x01") + '\0' + static_cast<char>(dictionary.size()) + '\0' + dictionary;
    bytes.append(reinterpret_cast<const char*>(values.data()), 8 * values.size());
    write_bytes(folder_ / name, bytes);
  }
  static std::set<std::string> keys(const json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
  }

  TemporaryFolder folder_;
};

using Keys = std::set<std::string>;
constexpr const char* sound_plugins = GEODROME_BINARY_DIR "/tests/sound_plugins";

TEST_F(Compare, FiguresHaveTheKeysOfTheSchema) {
  const json f = cube_figures({"--stage", "solver=chen_han,edge_dijkstra", "--growth", "1"});
  EXPECT_EQ(f["schema"], "geodrome-comparison/1");
  EXPECT_EQ(keys(f),
            (Keys{"schema", "version", "input", "sources", "targets", "truth", "near", "far", "combinations"}));
  EXPECT_EQ(keys(f["input"]), (Keys{"file", "kind", "rows", "faces", "diagonal"}));
  EXPECT_EQ(keys(f["sources"][0]), (Keys{"entry", "row", "position"}));
  EXPECT_EQ(keys(f["truth"]), (Keys{"kind", "name", "text"}));
  const json& c = f["combinations"][1];
  EXPECT_EQ(keys(c), (Keys{"name", "stages", "error", "factor", "never_shorter", "surface", "seconds", "memory",
                           "errors", "reach_differs", "unreachable", "invariants", "guarantee", "counters", "growth"}));
  EXPECT_EQ(keys(c["seconds"]), (Keys{"stages", "prepare", "per_source", "sources"}));
  EXPECT_EQ(keys(c["memory"]), (Keys{"peak_bytes", "prepared_bytes"}));
  EXPECT_EQ(keys(c["errors"]),
            (Keys{"compared", "max_over", "max_under", "mean", "quantiles", "near", "far", "histogram"}));
  EXPECT_EQ(keys(c["errors"]["quantiles"]), (Keys{"0.5", "0.9", "0.99", "1"}));
  EXPECT_EQ(keys(c["errors"]["near"]), (Keys{"compared", "mean", "max"}));
  EXPECT_EQ(keys(c["errors"]["histogram"]), (Keys{"decades", "counts", "zero"}));
  EXPECT_EQ(keys(c["invariants"][0]), (Keys{"name", "holds", "worst", "promised"}));
  EXPECT_EQ(keys(c["guarantee"]), (Keys{"stated", "worst", "held", "why"}));
  EXPECT_EQ(keys(c["growth"][0]),
            (Keys{"rows", "vertices", "faces", "prepare", "per_source", "peak_bytes", "counters"}));
  EXPECT_TRUE(c["error"].is_null());
  EXPECT_TRUE(c["factor"].is_null());
  EXPECT_EQ(c["stages"], json({{"solver", "edge_dijkstra"}}));
}

TEST_F(Compare, HoldsSolversAgainstTheFirstThatRuns) {
  const json f = cube_figures({"--stage", "solver=no_such,cgal,edge_dijkstra", "--sources", "all"}, 2);
  EXPECT_EQ(f["truth"]["kind"], "first");
  EXPECT_EQ(f["truth"]["name"], "cgal");
  const json& failed = f["combinations"][0];
  EXPECT_EQ(keys(failed), (Keys{"name", "stages", "error"}));
  EXPECT_EQ(failed["error"]["status"], 2);
  EXPECT_NE(failed["error"]["text"].get<std::string>().find("no_such"), std::string::npos);
  EXPECT_EQ(f["combinations"][1]["errors"]["mean"], 0);
  EXPECT_EQ(f["combinations"][1]["errors"]["histogram"]["zero"], 8 * 7);
  EXPECT_TRUE(f["combinations"][1]["guarantee"]["held"].is_null());
  EXPECT_GT(f["combinations"][2]["errors"]["max_over"], 0.01);
  EXPECT_LT(f["combinations"][2]["errors"]["max_under"], 1e-14);
  EXPECT_EQ(f["combinations"][2]["reach_differs"], 0);
  EXPECT_EQ(f["combinations"][2]["seconds"]["sources"].size(), 8u);
}

TEST_F(Compare, ATruthFromAFileGivesErrorsThatCanBeCheckedByHand) {
  write_npy("truth.npy", "(1, 8)", from_corner());
  const json f = cube_figures({"--stage", "solver=chen_han,edge_dijkstra", "--truth", file("truth.npy")});
  const json &exact = f["combinations"][0], &edges = f["combinations"][1];
  EXPECT_EQ(f["truth"]["kind"], "file");
  EXPECT_LT(exact["errors"]["quantiles"]["1"], 1e-14);
  EXPECT_EQ(exact["guarantee"]["held"], true);
  EXPECT_EQ(exact["errors"]["compared"], 7);
  // Along edges the opposite corner is an edge and a diagonal away, or three edges.
  const double worst = edges["errors"]["max_over"];
  EXPECT_GE(worst, (2 + std::sqrt(8.0)) / std::sqrt(20.0) - 1 - 1e-12);
  EXPECT_EQ(edges["errors"]["far"]["compared"], 7);
  EXPECT_EQ(edges["errors"]["near"]["compared"], 0);
  EXPECT_TRUE(edges["errors"]["near"]["mean"].is_null());
}

TEST_F(Compare, OfATruthForAllPairsTheRowsOfTheSourcesAreTaken) {
  const auto all = run_geodrome(folder_, {"distances", file("cube.off"), "-o", file("all.npy")});
  ASSERT_EQ(all.status, 0) << all.err;
  const json f = cube_figures({"--solver", "cgal", "--sources", "6,2", "--truth", file("all.npy")});
  EXPECT_LT(f["combinations"][0]["errors"]["quantiles"]["1"], 1e-14);
  EXPECT_EQ(f["combinations"][0]["guarantee"]["held"], true);
}

TEST_F(Compare, ATruthThatDoesNotFitIsRefused) {
  write_npy("t.npy", "(1, 7)", std::vector<double>(7, 1));
  expect(cube({"--truth", file("t.npy")}), 3, "(1, 7), but must have (1, 8)");
  write_bytes(folder_ / "n.npy", "nothing");
  expect(cube({"--truth", file("n.npy")}), 3, "n.npy");
  expect(cube({"--truth", file("none.npy")}), 3, "none.npy");
  expect(cube({"--truth", "second"}), 2, "exact:SOLVER");
  expect(cube({"--truth", "exact:edge_dijkstra"}), 2, "not exact");
}

TEST_F(Compare, AnExactTruthJudgesGuarantees) {
  const json f = cube_figures(
      {"--stage", "solver=schreiber,aleksandrov:delta=0.5,edge_dijkstra", "--truth", "exact:cgal", "--sources", "0,3"});
  EXPECT_EQ(f["truth"]["kind"], "exact");
  EXPECT_EQ(f["truth"]["name"], "cgal");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(f["combinations"][i]["guarantee"]["held"], true) << i;
  EXPECT_EQ(f["combinations"][0]["guarantee"]["stated"], 1);
  EXPECT_EQ(f["combinations"][1]["guarantee"]["stated"], 1.5);
  EXPECT_LE(f["combinations"][1]["guarantee"]["worst"], 1.5);
  EXPECT_TRUE(f["combinations"][2]["guarantee"]["stated"].is_null());
}

TEST_F(Compare, ABrokenGuaranteeIsToldLoudly) {
  const std::vector<std::string> arguments{
      "--stage", "solver=chen_han,test_straight", "--plugin-path", sound_plugins, "--truth", "exact"};
  const Outcome outcome = cube(arguments);
  expect(outcome, 5, "broken promise: test_straight: ");
  EXPECT_NE(outcome.err.find("below the true ones"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("1.5 BROKEN"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("1 held"), std::string::npos) << outcome.out;
  const json f = cube_figures(arguments, 5);
  EXPECT_EQ(f["combinations"][1]["guarantee"]["held"], false);
  EXPECT_EQ(f["combinations"][0]["guarantee"]["held"], true);
}

TEST_F(Compare, AnEstimateThatStatesNothingBreaksNothing) {
  const json f = cube_figures({"--solver", "test_estimate", "--plugin-path", sound_plugins, "--truth", "exact"});
  const json& c = f["combinations"][0];
  EXPECT_EQ(c["never_shorter"], false);
  EXPECT_GT(c["errors"]["max_under"], 0.1);
  EXPECT_TRUE(c["guarantee"]["held"].is_null());
  EXPECT_TRUE(c["guarantee"]["stated"].is_null());
  for (const json& invariant : c["invariants"])
    EXPECT_EQ(invariant["promised"],
              invariant["name"] == "D(s,s)" || invariant["name"] == "reach" || invariant["name"] == "no NaN")
        << invariant;
}

TEST_F(Compare, InvariantsOfTheRowsAreShown) {
  // Two squares apart: what runs straight through space reaches what it cannot.
  write_bytes(folder_ / "two.off",
              "OFF\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n"
              "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n");
  const std::vector<std::string> arguments{"--stage", "solver=chen_han,test_straight", "--plugin-path", sound_plugins};
  const json f = figures(file("two.off"), arguments, 5);
  const json &right = f["combinations"][0], &wrong = f["combinations"][1];
  EXPECT_EQ(right["unreachable"], 4);
  EXPECT_EQ(wrong["unreachable"], 0);
  EXPECT_EQ(wrong["reach_differs"], 4);
  for (const json& invariant : right["invariants"]) EXPECT_NE(invariant["holds"], false) << invariant;
  for (const json& invariant : wrong["invariants"])
    EXPECT_EQ(invariant["holds"] == false, invariant["name"] == "reach");
  EXPECT_NE(run(file("two.off"), arguments).out.find("NOT reach"), std::string::npos);
}

TEST_F(Compare, AllCombinationsOfStagesRunOnASample) {
  const json f = figures(torus(), {"--stage", "decimator=greedy,none", "--stage", "solver=chen_han,edge_dijkstra",
                                   "--reconstructor", "advancing_front", "--sources", "0,5"});
  ASSERT_EQ(f["combinations"].size(), 4u);
  EXPECT_EQ(f["combinations"][1]["name"], "greedy, edge_dijkstra");
  EXPECT_EQ(f["combinations"][2]["name"], "none, chen_han");
  EXPECT_EQ(f["combinations"][2]["stages"]["decimator"], "none");
  EXPECT_EQ(f["combinations"][2]["stages"]["reconstructor"], "advancing_front");
  EXPECT_TRUE(f["input"]["faces"].is_null());
  const auto seconds = [&](int i, const char* stage) { return f["combinations"][i]["seconds"]["stages"][stage]; };
  // What combinations share is computed once, and told of each.
  for (int i = 1; i < 4; ++i) EXPECT_EQ(seconds(0, "control"), seconds(i, "control"));
  EXPECT_EQ(seconds(0, "reconstructor"), seconds(1, "reconstructor"));
  EXPECT_NE(seconds(0, "reconstructor"), seconds(2, "reconstructor"));
  EXPECT_LT(f["combinations"][0]["surface"]["faces"], f["combinations"][2]["surface"]["faces"]);
  EXPECT_EQ(f["combinations"][0]["errors"]["compared"], 2 * 599);
}

TEST_F(Compare, AStageThatRefusesLeavesTheOthersRunning) {
  const json f = figures(torus(), {"--stage", "reconstructor=delaunay_cut:boundary=no_such,delaunay_cut"}, 2);
  EXPECT_EQ(f["combinations"][0]["error"]["status"], 2);
  EXPECT_TRUE(f["combinations"][1]["error"].is_null());
  EXPECT_EQ(f["truth"]["name"], "delaunay_cut");
}

TEST_F(Compare, WithANonExactTruthOfACloudTheGuaranteeIsNotJudged) {
  const std::string input = torus();
  const auto all = run_geodrome(folder_, {"distances", input, "--sources", "3,4", "-o", file("t.npy")});
  ASSERT_EQ(all.status, 0) << all.err;
  const json f = figures(input, {"--solver", "schreiber", "--sources", "3,4", "--truth", file("t.npy")});
  EXPECT_LT(f["combinations"][0]["errors"]["quantiles"]["1"], 1e-12) << "same rule as 'distances'";
  EXPECT_TRUE(f["combinations"][0]["guarantee"]["held"].is_null());
  EXPECT_EQ(f["combinations"][0]["guarantee"]["stated"], 1);
}

TEST_F(Compare, AMeshGrowsByCuttingItsFaces) {
  const json f = cube_figures({"--stage", "solver=chen_han,edge_dijkstra", "--growth", "2"});
  for (const json& combination : f["combinations"]) {
    const json& growth = combination["growth"];
    ASSERT_EQ(growth.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(growth[i]["faces"], 12 << (2 * i));
    EXPECT_EQ(growth[0]["prepare"], combination["seconds"]["prepare"]);
    EXPECT_EQ(growth[1]["vertices"], 8 + 18);
  }
  const Outcome table = cube({"--stage", "solver=chen_han", "--growth", "1"});
  EXPECT_NE(table.out.find("growth"), std::string::npos) << table.out;
}

TEST_F(Compare, ASampleGrowsByParts) {
  const json f = figures(sample("sphere"), {"--growth", "1", "--sources", "599"});
  const json& growth = f["combinations"][0]["growth"];
  ASSERT_EQ(growth.size(), 2u);
  EXPECT_GE(growth[0]["rows"], 300);
  EXPECT_LE(growth[0]["rows"], 301);
  EXPECT_EQ(growth[1]["rows"], 600);
  EXPECT_LT(growth[0]["faces"], growth[1]["faces"]);
}

TEST_F(Compare, APartOfASampleThatIsTooSparseIsLeftOutAndTold) {
  const Outcome outcome = run(torus(), {"--growth", "8", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("growth: chen_han, 1/256 of the points: left out"), std::string::npos) << outcome.err;
  EXPECT_LT(json::parse(outcome.out)["combinations"][0]["growth"].size(), 9u);
}

TEST_F(Compare, SourcesMayLieAnywhere) {
  write_bytes(folder_ / "s.txt", "3\n1 0.25 -0.5 + 2\n0 0.5 0.25 0.25\n");
  write_bytes(folder_ / "tet.off",
              "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n");
  const json f = figures(file("tet.off"), {"--stage", "solver=chen_han,cgal,edge_dijkstra", "--sources",
                                           "@" + file("s.txt"), "--growth", "1", "--truth", "exact"});
  EXPECT_EQ(f["sources"][0]["row"], 3);
  EXPECT_EQ(f["sources"][0]["position"], json({-1.0, -1.0, 1.0}));
  EXPECT_TRUE(f["sources"][1]["row"].is_null());
  EXPECT_EQ(f["sources"][1]["entry"], "@1");
  for (const json& combination : f["combinations"]) {
    EXPECT_TRUE(combination["error"].is_null());
    EXPECT_EQ(combination["growth"].size(), 2u);
  }
  EXPECT_LT(f["combinations"][1]["errors"]["quantiles"]["1"], 1e-13);
}

TEST_F(Compare, TheTableHasOneLineForEachCombinationWithin120Columns) {
  const Outcome outcome =
      cube({"--stage", "solver=chen_han,aleksandrov:delta=0.25,no_such,edge_dijkstra", "--truth", "exact"});
  EXPECT_EQ(outcome.status, 2);
  std::istringstream lines(outcome.out);
  std::vector<std::string> text;
  for (std::string line; std::getline(lines, line);) text.push_back(line);
  ASSERT_GE(text.size(), 6u);
  for (const int i : {0, 1, 2, 4}) EXPECT_LE(text[i].size(), 120u) << text[i];
  EXPECT_EQ(text[2].substr(0, 22), "aleksandrov:delta=0.25");
  EXPECT_NE(text[2].find("1.25 held"), std::string::npos);
  EXPECT_NE(text[3].find("not run: "), std::string::npos);
  EXPECT_NE(text[5].find("truth: "), std::string::npos);
}

TEST_F(Compare, FiguresGoIntoAFileToo) {
  const Outcome outcome = cube({"-o", file("f.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("s/source"), std::string::npos) << "the table stays";
  const json f = json::parse(read_bytes(folder_ / "f.json"));
  EXPECT_EQ(f["combinations"][0]["name"], "chen_han");
  EXPECT_FALSE(f.contains("view"));
}

TEST_F(Compare, MistakesAreUsageErrorsBeforeAnythingIsComputed) {
  expect(cube({"--stage", "solvers=cgal"}), 2, "no stage 'solvers'");
  expect(cube({"--stage", "tangent=jet,pca"}), 2, "mesh");
  expect(cube({"--stage", "solver=cgal", "--solver", "schreiber"}), 2, "both");
  expect(cube({"--sources", "99"}), 2, "99");
  expect(cube({"--growth", "-1"}), 2, "--growth");
  expect(cube({"--growth", "17"}), 2, "--growth");
  expect(cube({"-o", file("f.txt")}), 2, ".json");
  expect(cube({"--html", file("f.txt")}), 2, ".html");
  write_npy("t.json", "(1, 8)", from_corner());
  expect(cube({"--html", file("no/p.html")}), 3, "make it first");
}

TEST_F(Compare, ThePageHoldsFiguresAndViewOrIsRefusedWithTheWayToGetIt) {
  const Outcome outcome = cube({"--stage", "solver=chen_han,cgal", "--html", file("p.html")});
  if (!std::filesystem::exists(GEODROME_BINARY_DIR "/share/geodrome/compare.html")) {
    expect(outcome, 3, "nodejs and npm");
    EXPECT_FALSE(std::filesystem::exists(file("p.html")));
    return;
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = read_bytes(folder_ / "p.html");
  const std::string open = "<script type=\"application/json\" id=\"geodrome-comparison\">";
  const std::size_t begin = page.find(open);
  ASSERT_NE(begin, std::string::npos);
  const json data = json::parse(page.substr(begin + open.size(), page.find("</script>", begin) - begin - open.size()));
  EXPECT_EQ(data["schema"], "geodrome-comparison/1");
  EXPECT_EQ(data["view"]["surfaces"].size(), 1u);
  EXPECT_EQ(data["view"]["combinations"].size(), 2u);
}

}  // namespace
