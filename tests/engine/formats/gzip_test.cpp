// SPDX-License-Identifier: MIT
#include "engine/formats/gzip.hpp"

#include <zlib.h>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

std::string packed(const std::string& bytes) {
  z_stream stream{};
  constexpr int gzip = 16 + MAX_WBITS, memory = 8;
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip, memory, Z_DEFAULT_STRATEGY), Z_OK);
  std::string result(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

const std::string square_off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

TEST(Gzip, IsUnpackedWhateverTheNameSays) {
  const Input plain = read_bytes("m.off", square_off);
  for (const std::string name : {"m.off.gz", "m.OFF.GZ", "m.off", "m.gz"}) {
    const Input input = read_bytes(name, packed(square_off));
    EXPECT_EQ(input.triangles, plain.triangles) << name;
    EXPECT_EQ(input.hash, plain.hash) << name;
  }
}

TEST(Gzip, LeavesTheEndingToTellTheFormat) {
  EXPECT_EQ(read_bytes("p.xyz.gz", packed("1 2 3\n")).format, "xyz");
  EXPECT_EQ(read_bytes("p.csv.gz", packed("x,y,z\n1,2,3\n")).format, "csv");
  EXPECT_EQ(read_bytes("m.obj.gz", packed("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")).format, "obj");
  EXPECT_EQ(read_bytes("p.xyz", packed("1 2 3\n")).format, "xyz");
  expect_refused([] { read_bytes("p.gz", packed("1 2 3\n")); }, InputFault::unsupported, "tells the format");
}

TEST(Gzip, MayHaveSeveralMembersAndZerosAtTheEnd) {
  for (std::size_t cut = 0; cut <= square_off.size(); ++cut)
    EXPECT_EQ(
        read_bytes("m.off.gz", packed(square_off.substr(0, cut)) + packed(square_off.substr(cut))).triangles.size(),
        2u);
  EXPECT_EQ(read_bytes("m.off.gz", packed(square_off) + std::string(512, '\0')).triangles.size(), 2u);
}

TEST(Gzip, CutAnywhereIsRefused) {
  const std::string whole = packed(square_off);
  for (std::size_t size = 2; size < whole.size(); ++size)
    expect_refused([&] { read_bytes("m.off.gz", whole.substr(0, size)); }, InputFault::truncated, "ends too early");
}

TEST(Gzip, DamagedAnywhereIsRefusedOrTheSame) {
  const std::string whole = packed(square_off);
  for (std::size_t at = 2; at < whole.size(); ++at)
    for (const int bit : {0, 3, 7}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      std::optional<Input> input;
      const auto error = error_of([&] { input = read_bytes("m.off.gz", damaged); });
      if (input) {
        EXPECT_EQ(input->triangles.size(), 2u) << at;  // a byte of the time stamp or the like
      } else {
        EXPECT_NE(error->message().find("m.off.gz"), std::string::npos) << error->what();
      }
    }
}

TEST(Gzip, WithSomethingElseAtTheEndIsRefused) {
  expect_refused([] { read_bytes("m.off.gz", packed(square_off) + "hello"); }, InputFault::syntax, "5 bytes");
  expect_refused([] { read_bytes("m.off.gz", packed(packed(square_off))); }, InputFault::syntax, "once more");
  expect_refused([] { read_bytes("m.off.gz", packed("")); }, InputFault::empty, "0 bytes");
}

TEST(Gzip, IsRefusedBeyondItsLimit) {
  input::SourceFile file{"zeros.gz", packed(std::string(1'000'000, '0')), false};
  EXPECT_LT(file.bytes.size(), 2'000u);
  expect_refused([file]() mutable { input::unpack_gzip(file, 999'999); }, InputFault::unsupported, "999999");
  input::unpack_gzip(file, 1'000'000);
  EXPECT_EQ(file.bytes.size(), 1'000'000u);
  EXPECT_EQ(input::largest_unpacked(1), 256'000'000u);
  EXPECT_EQ(input::largest_unpacked(10'000'000), 1'000'000'000u);
}

TEST(Gzip, IsReadForWeightsToo) {
  const TemporaryFolder folder;
  const std::string weights = (folder / "w.txt.gz").string();
  std::ofstream(weights, std::ios::binary) << packed("2\n3\n");
  EXPECT_EQ(read_bytes("m.off.gz", packed(square_off), {.weights = weights}).weights, (std::vector<double>{2, 3}));
}

}  // namespace
}  // namespace geodrome::testing
