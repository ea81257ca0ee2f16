// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

const std::filesystem::path bad = std::filesystem::path(GEODROME_SHARED_DATA) / "bad";

/// An entry of the set's table; printed as the file's name.
struct Entry {
  json fields;
  friend void PrintTo(const Entry& entry, std::ostream* out) { *out << entry.fields["file"].get<std::string>(); }
};

std::vector<Entry> entries() {
  if (!std::filesystem::exists(bad / "expected.json")) return {};
  std::vector<Entry> all;
  for (const json& fields : json::parse(read_bytes(bad / "expected.json"))) all.push_back({fields});
  return all;
}

/// One broken or odd file through the program, by the verdict that is expected of it.
class BadFiles : public ::testing::TestWithParam<Entry> {
 protected:
  bool rejected() const { return GetParam().fields["verdict"] == "reject"; }
  std::string verdict() const { return GetParam().fields["verdict"]; }
  std::string error() const { return GetParam().fields["error"]; }
  std::string path() const { return (bad / GetParam().fields["file"].get<std::string>()).string(); }
  /// Told by their content, these are sound: the set allows that.
  bool readable_by_content() const {
    return GetParam().fields["file"] == "wrong_extension.ply" || GetParam().fields["file"] == "gzipped.ply";
  }

  TemporaryFolder folder_;
};

TEST_P(BadFiles, CheckEndsWithThreeForWhatCannotBeUsedAndZeroOtherwise) {
  const Outcome outcome = run_geodrome(folder_, {"check", path(), "--json"});
  const json report = json::parse(outcome.out);
  if (rejected() && !readable_by_content()) {
    EXPECT_EQ(outcome.status, 3) << outcome.err;
  }
  if (verdict().starts_with("accept") && verdict() != "accept or reject") {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
  EXPECT_EQ(report["usable"].get<bool>(), outcome.status == 0);
  if (outcome.status != 0) {
    EXPECT_EQ(report["error"]["fault"], error());
  }
}

TEST_P(BadFiles, DistancesAreNumbersOrAnErrorThatNamesTheReason) {
  const std::string out = (folder_ / "d.csv").string();
  const Outcome outcome =
      run_geodrome(folder_, {"distances", path(), "-o", out, "--report", (folder_ / "r.json").string()});
  if (outcome.status == 0) {
    EXPECT_EQ(read_bytes(out).find("nan"), std::string::npos);
    const json matrix = json::parse(read_bytes(folder_ / "r.json"))["matrix"];
    EXPECT_EQ(matrix["reach"]["missed"], 0);
    EXPECT_EQ(matrix["reach"]["impossible"], 0);
    for (const auto& [name, check] : matrix["invariants"].items()) {
      EXPECT_TRUE(!check.is_object() || check["holds"].get<bool>()) << name;
    }
    return;
  }
  EXPECT_TRUE(outcome.status == 3 || outcome.status == 4) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(out));
  const bool needs_a_manifold = GetParam().fields["file"] == "duplicate_faces.off";
  EXPECT_TRUE(rejected() || verdict() == "accept or reject" || error() == "nonmanifold" || needs_a_manifold)
      << outcome.err;
  if (error() == "nonmanifold" || needs_a_manifold) {
    EXPECT_TRUE(outcome.err.find("nonmanifold") != std::string::npos ||
                outcome.err.find("not orient") != std::string::npos)
        << outcome.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, BadFiles, ::testing::ValuesIn(entries()), [](const auto& info) {
  std::string name = info.param.fields["file"];
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BadFiles);

TEST(BadFilesPresence, TheSetIsThere) {
  if (entries().empty()) GTEST_SKIP() << "no " << bad << ": broken files were not tried";
  EXPECT_GE(entries().size(), 40u);
}

}  // namespace
