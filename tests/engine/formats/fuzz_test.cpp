// SPDX-License-Identifier: MIT
#include <iterator>
#include <random>

#include "geodrome/surface.hpp"
#include "tests/support/input_files.hpp"

// Broken copies of sound files: whatever the bytes, reading ends in a valid Input or in an InputError.
namespace geodrome::testing {
namespace {

std::string written(const std::string& name) {
  const SurfaceMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.25}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  const TemporaryFolder folder;
  write_mesh(folder / name, mesh);
  std::ifstream stream(folder / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const std::string ascii_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0.5\n1 1 1\n3 0 1 2\n4 0 1 3 2\n";
const std::string big_endian_ply =
    "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\nproperty short z\n"
    "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n" +
    std::string(
        "\0\0\0\0\0\0"
        "\0\1\0\0\0\0"
        "\0\0\0\1\0\0"
        "\3\0\1\2",
        22);
const std::string ascii_stl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "s\n";

const std::string strips_ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0 1 0 0\n0 1 0 1 1 0\n8 0 1 2 3 -1 0 2 "
    "3\n";

struct Sound {
  std::string name, bytes;
};

std::vector<Sound> sound_files() {
  return {{"m.off", written("m.off")},
          {"m.obj", written("m.obj")},
          {"m.ply", written("m.ply")},
          {"m.stl", written("m.stl")},
          {"a.ply", ascii_ply},
          {"b.ply", big_endian_ply},
          {"a.stl", ascii_stl},
          {"p.xyz", "0 0 0\n1 2.5 3e-1\n# c\n-4 5 6\n"},
          {"t.ply", strips_ply},
          {"u.off", "OFF\n8 1 0\n0 0 0 3 0 0\n3 3 0 2 3 0\n2 1 0 1 1 0\n1 3 0 0 3 0\n8 0 1 2 3 4 5 6 7\n"},
          {"c.csv", "id;x;y;z\n7;0;0;0.5\n3;1;2.5;3e-1\n"},
          {"n.pts", "3\n0 0 0 1\n1 2 3 4\n4 5 6 7\n"},
          {"l.obj", "v 0 0 0\nv 1 0 0 \\\n 1\ng a\\\nv 0 1 0\nf 1 2 \\\n3\n"}};
}

void expect_survives(const std::string& name, const std::string& bytes) {
  for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.weld = true, .drop_nonfinite = true}}) {
    std::optional<Input> input;
    const auto error = error_of([&] { input = read_bytes(name, bytes, options); });
    if (input) expect_valid(*input);
    if (error) {
      EXPECT_NE(std::string(error->what()).find(name), std::string::npos) << error->what();
    }
  }
}

TEST(InputFuzz, SoundFilesAreRead) {
  for (const auto& [name, bytes] : sound_files()) EXPECT_NO_THROW(expect_valid(read_bytes(name, bytes))) << name;
}

TEST(InputFuzz, TruncatedFilesAreRefusedOrValid) {
  for (const auto& [name, bytes] : sound_files())
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      SCOPED_TRACE(name + " cut to " + std::to_string(size));
      expect_survives(name, bytes.substr(0, size));
    }
}

TEST(InputFuzz, BinaryFilesCutAnywhereAreRefused) {
  for (const std::string name : {"m.ply", "m.stl"}) {
    const std::string bytes = written(name);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_TRUE(error_of([&] { read_bytes(name, bytes.substr(0, size)); })) << name << " cut to " << size;
  }
}

TEST(InputFuzz, ChangedBytesAreRefusedOrValid) {
  std::mt19937_64 random(20240607);
  for (const auto& [name, bytes] : sound_files())
    for (int round = 0; round < 1000; ++round) {
      std::string changed = bytes;
      for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes)
        changed[random() % changed.size()] = static_cast<char>(random());
      SCOPED_TRACE(name + " round " + std::to_string(round));
      expect_survives(name, changed);
    }
}

// Digits in place of digits: counts and indices that are wrong, in files that are else well formed.
TEST(InputFuzz, ChangedDigitsAreRefusedOrValid) {
  std::mt19937_64 random(7);
  for (const auto& [name, bytes] : sound_files())
    for (int round = 0; round < 1000; ++round) {
      std::string changed = bytes;
      const std::size_t start = random() % changed.size(), at = changed.find_first_of("0123456789", start);
      if (at == changed.npos) continue;
      const char* const values[] = {"-", "9", "99999999999", "nan", "e308", " ", "\n", "0"};
      changed.replace(at, 1, values[random() % std::size(values)]);
      SCOPED_TRACE(name + " round " + std::to_string(round));
      expect_survives(name, changed);
    }
}

}  // namespace
}  // namespace geodrome::testing
