// SPDX-License-Identifier: MIT
// The file of a pair oracle: what is put in comes out, and every way in which it may be the wrong file is refused.
#include "engine/output/index_file.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <ostream>

#include "tests/support/input_files.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

using test::mapped;
using test::plane_grid;

constexpr OptionSpec specs[] = {number_option("delta", "0.1", 0, 1, "", ""), choice_option("mode", "on", "on|off", "")};

PluginInfo solver(const std::string& name) {
  PluginInfo info;
  info.stage = "solver", info.name = name;
  info.options = {{"delta", OptionType::number, "0.1", 0, 1, "", "", ""},
                  {"mode", OptionType::choice, "on", 0, 0, "on|off", "", ""}};
  return info;
}

IndexIdentity identity(const SurfaceMesh& mesh, const std::string& options = "", std::uint64_t seed = 1,
                       const std::string& name = "some") {
  return identity_of(mesh, solver(name), OptionValues(specs, options), seed);
}

class IndexFile : public ::testing::Test {
 protected:
  void SetUp() override {
    size_ = write_index(file_, identity(*mesh_), [&](std::ostream& out) { out << payload_; });
  }
  void expect_refusal(const IndexIdentity& of, InputFault fault, const std::string& part) const {
    expect_refused([&] { open_index(file_, of); }, fault, part);
    expect_refused([&] { open_index(file_, of); }, fault, file_.filename().string());
  }
  void expect_damage_is_refused(const std::string& bytes, InputFault fault, const std::string& part) const {
    write_bytes(file_, bytes);
    expect_refusal(identity(*mesh_), fault, part);
  }

  const MeshPtr mesh_ = plane_grid(3);
  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "some.index";
  const std::string payload_ = std::string("payload\0 with zeros", 19) + std::string(200'000, 'x');
  std::uint64_t size_ = 0;
};

TEST_F(IndexFile, GivesBackWhatWasSaved) {
  TextInput in = open_index(file_, identity(*mesh_));
  const std::string read{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(read == payload_);
  EXPECT_EQ(size_, std::filesystem::file_size(file_));
}

TEST_F(IndexFile, MayHoldNothing) {
  write_index(file_, identity(*mesh_), [](std::ostream&) {});
  TextInput in = open_index(file_, identity(*mesh_));
  EXPECT_EQ(in.peek(), std::ifstream::traits_type::eof());
}

TEST_F(IndexFile, TakesTheSameNumberWrittenInAnotherWay) {
  EXPECT_NO_THROW(open_index(file_, identity(*mesh_, "delta=0.10")));
  EXPECT_NO_THROW(open_index(file_, identity(*mesh_, "delta=1e-1,mode=on")));
}

TEST_F(IndexFile, IsRefusedForAnotherSolverNamingBoth) {
  expect_refusal(identity(*mesh_, "", 1, "other"), InputFault::unsupported, "solver_some, not solver_other");
}

TEST_F(IndexFile, IsRefusedForAnotherOptionValueNamingBoth) {
  expect_refusal(identity(*mesh_, "delta=0.2"), InputFault::unsupported, "delta was 0.1 and is 0.2");
  expect_refusal(identity(*mesh_, "delta=0.2,mode=off"), InputFault::unsupported,
                 "delta was 0.1 and is 0.2, mode was on and is off");
}

TEST_F(IndexFile, IsRefusedIfThePluginHasOtherOptionsNow) {
  IndexIdentity now = identity(*mesh_);
  now.options["fresh"] = "3";
  expect_refusal(now, InputFault::unsupported, "fresh was absent and is 3");
  now = identity(*mesh_);
  now.options.erase("mode");
  expect_refusal(now, InputFault::unsupported, "mode was on and is absent");
}

TEST_F(IndexFile, IsRefusedInOneShortLineWhateverItSaysOfItself) {
  IndexIdentity other = identity(*mesh_);
  for (int i = 0; i < 500; ++i) other.options["\x1B" + std::to_string(i)] = std::string(500, '\n');
  write_index(file_, other, [](std::ostream&) {});
  const auto error = error_of([&] { open_index(file_, identity(*mesh_)); });
  ASSERT_TRUE(error);
  EXPECT_LT(std::string(error->what()).size(), 1500u);
  EXPECT_EQ(std::string(error->what()).find_first_of("\x1B\n"), std::string::npos) << error->what();
}

TEST_F(IndexFile, IsRefusedForAnotherMesh) {
  expect_refusal(identity(*plane_grid(4)), InputFault::unsupported, "16 vertices, 18 faces");
  const MeshPtr moved = mapped(mesh_, [](const Vec3& p) { return p.x == 1 ? p + Vec3{0, 0, 1e-15} : p; });
  expect_refusal(identity(*moved), InputFault::unsupported, "another mesh");
  std::vector<Triangle> triangles(mesh_->triangles().begin(), mesh_->triangles().end());
  std::swap(triangles[0], triangles[1]);
  const std::vector<Vec3> positions(mesh_->positions().begin(), mesh_->positions().end());
  expect_refusal(identity(SurfaceMesh(positions, triangles)), InputFault::unsupported, "another mesh");
}

TEST_F(IndexFile, IsRefusedForOtherFaceWeights) {
  const std::vector<Vec3> positions(mesh_->positions().begin(), mesh_->positions().end());
  const std::vector<Triangle> triangles(mesh_->triangles().begin(), mesh_->triangles().end());
  const SurfaceMesh weighted(positions, triangles, std::vector<double>(triangles.size(), 2));
  expect_refusal(identity(weighted), InputFault::unsupported, "another mesh");
}

TEST_F(IndexFile, IsRefusedForAnotherSeed) {
  expect_refusal(identity(*mesh_, "", 2), InputFault::unsupported, "seed: 1, not 2");
}

TEST_F(IndexFile, IsRefusedIfItEndsTooEarlyWhereverThatIs) {
  const std::string whole = read_bytes(file_);
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{8}, std::size_t{63}, std::size_t{64},
                                 std::size_t{100}, whole.size() - 1})
    expect_damage_is_refused(whole.substr(0, size), InputFault::truncated, "");
}

TEST_F(IndexFile, IsRefusedIfItIsLongerThanItWas) {
  expect_damage_is_refused(read_bytes(file_) + "y", InputFault::syntax, "bytes instead of");
}

TEST_F(IndexFile, IsRefusedIfAByteChangedWhereverThatIs) {
  const std::string whole = read_bytes(file_);
  std::vector<std::size_t> places{whole.size() - 1, whole.size() / 2, whole.size() - payload_.size()};
  for (std::size_t place = 16; place < 80; ++place) places.push_back(place);
  for (const std::size_t place : places) {
    std::string damaged = whole;
    damaged[place] ^= '\x40';
    expect_damage_is_refused(damaged, InputFault::syntax, "damaged");
  }
}

TEST_F(IndexFile, IsRefusedIfItIsOfAnotherFormatVersionNamingBoth) {
  std::string other = read_bytes(file_);
  other[8] = 7;
  expect_damage_is_refused(other, InputFault::unsupported, "format version 7, this program reads 1");
}

TEST_F(IndexFile, IsRefusedIfItIsSomethingElse) {
  expect_damage_is_refused("OFF\n3 1 0\n0 0 0\n", InputFault::syntax, "no index file");
  expect_damage_is_refused("OFF", InputFault::syntax, "no index file");
  expect_refused([&] { open_index(folder_.path(), identity(*mesh_)); }, InputFault::io, "no regular file");
}

TEST_F(IndexFile, IsNotWrittenIfSavingThrows) {
  const std::string before = read_bytes(file_);
  const auto fail = [](std::ostream& out) {
    out << "half";
    throw PluginError("gone");
  };
  EXPECT_THROW(write_index(file_, identity(*mesh_), fail), PluginError);
  EXPECT_TRUE(read_bytes(file_) == before);
  EXPECT_THROW(write_index(folder_ / "new", identity(*mesh_), fail), PluginError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
}

}  // namespace
}  // namespace geodrome::testing
