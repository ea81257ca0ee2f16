// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>

#include "tests/support/input_files.hpp"

// OFF and text PLY are streams of numbers: lines mean little, and a broken file must show all the same.
namespace geodrome::testing {
namespace {

const std::string vertices = "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n";
const std::string faces = "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n", halves = "3 0 1 2\n3 0 2 3\n";

/// The same words, so many on each line.
std::string wrapped(const std::string& text, int words_a_line) {
  std::istringstream words(text);
  std::string result;
  int on_line = 0;
  for (std::string word; words >> word;) {
    result += word;
    result += ++on_line % words_a_line == 0 ? '\n' : ' ';
  }
  return result + "\n";
}

/// Every line, with `more` after it.
std::string with(std::string lines, const std::string& more) {
  for (std::size_t at = 0; (at = lines.find('\n', at)) != lines.npos; at += more.size() + 1) lines.insert(at, more);
  return lines;
}

std::string ply(const std::string& counts, const std::string& body, const std::string& vertex_properties = "") {
  std::istringstream in(counts);
  std::string vertex_count, face_count;
  in >> vertex_count >> face_count;
  return "ply\nformat ascii 1.0\nelement vertex " + vertex_count +
         "\nproperty float x\nproperty float y\nproperty float z\n" + vertex_properties + "element face " + face_count +
         "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

void expect_octahedron(const Input& input) {
  const Input plain = read_bytes("plain.off", "OFF\n6 8 12\n" + vertices + faces);
  EXPECT_EQ(input.positions, plain.positions);
  EXPECT_EQ(input.triangles, plain.triangles);
}

void expect_square(const std::string& name, const std::string& bytes) {
  SCOPED_TRACE(bytes);
  const Input input = read_bytes(name, bytes);
  EXPECT_EQ(input.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(input.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_FALSE(has_warning(input));
}

TEST(InputStreams, OffIsReadHoweverItsNumbersLieOnLines) {
  for (int words = 1; words <= 60; ++words) {
    SCOPED_TRACE(words);
    expect_octahedron(read_bytes("s.off", wrapped("OFF 6 8 12 " + vertices + faces, words)));
    expect_octahedron(read_bytes("s.off", "OFF\n6 8 12\n" + wrapped(vertices, words) + faces));
    expect_octahedron(read_bytes("s.off", "OFF\n6 8 12\n" + vertices + wrapped(faces, words)));
  }
}

TEST(InputStreams, PlyIsReadHoweverItsNumbersLieOnLines) {
  for (int words = 1; words <= 60; ++words) {
    SCOPED_TRACE(words);
    expect_octahedron(read_bytes("s.ply", ply("6 8", wrapped(vertices + faces, words))));
  }
}

TEST(InputStreams, RowsThatAreTornAreTold) {
  EXPECT_TRUE(has_finding(read_bytes("s.off", "OFF\n6 8 12\n" + wrapped(vertices + faces, 5)), "rows_across_lines"));
  EXPECT_TRUE(has_finding(read_bytes("s.ply", ply("6 8", wrapped(vertices + faces, 5))), "rows_across_lines"));
  EXPECT_FALSE(has_warning(read_bytes("s.off", "OFF\n6 8 12\n" + wrapped(vertices, 6) + faces)));
  EXPECT_FALSE(has_warning(read_bytes("s.off", "OFF\n6 8 12\n" + vertices + wrapped(faces, 2))));
}

TEST(InputStreams, OffTakesCountsOverLinesWithAndWithoutEdges) {
  expect_square("s.off", "OFF\n4\n2\n0\n" + square + halves);
  expect_square("s.off", "OFF\n4\n2\n" + square + halves);
  expect_square("s.off", "OFF # c\n# c\n4 # vertices\n\n2\r\n5\n" + square + halves);
}

TEST(InputStreams, OffTakesCommentsWithinFaces) {
  expect_square("s.off", "OFF\n4 2 0\n" + square + "3 0 # the first\r\n 1 2\n\n3 # the second\n0 2 3");
}

TEST(InputStreams, OffTakesWhatItsKeywordAnnouncesOnLinesOfItsOwn) {
  expect_square("s.off", "COFF\n4 2 0\n" + with(square, "\n255 0 0 255") + halves);
  expect_square("s.off", "COFF\n4 2 0\n" + with(square, "\n255 0 0") + halves);
  expect_square("s.off", "NOFF\n4 2 0\n" + with(square, "\n0 0 1") + halves);
  expect_square("s.off", "STCNOFF\n4 2 0\n" + with(square, " 0 0 1\n1 1 1 1 0.5 0.5") + halves);
}

TEST(InputStreams, OffTakesColoursOfFacesUntilTheLineEnds) {
  for (const std::string colour : {"", " 255 0 0", " 0.5 0.5 0.5 1.0", " 0 1 2 # c"})
    expect_square("s.off", "OFF\n4 2 0\n" + square + "3 0 1 2" + colour + "\n3 0 2 3\n");
  expect_square("s.off", "OFF\n4 2 0\n" + square + "3 0 1 2 7\n3 0 2 3 8\n");
  expect_square("s.off", "OFF\n4 2 0\n" + square + "3 0 1 2 3 0 2 3\n");  // no colour: the other face
}

TEST(InputStreams, OffTellsOfColoursThatDifferInLength) {
  const auto told = [](const std::string& faces) {
    return has_finding(read_bytes("s.off", "OFF\n4 2 0\n" + square + faces), "colours_differ");
  };
  EXPECT_TRUE(told("3 0 1 2 3 0 0\n3 0 1 3 3 0 0 2\n"));  // the second may be the corner 2 and the colour 3 3 0 0
  EXPECT_TRUE(told("3 0 1 2 7\n3 0 2 3\n"));
  EXPECT_FALSE(told("3 0 1 2 1 0 0\n3 0 2 3\n"));
  EXPECT_FALSE(told("3 0 1 2 1 0 0 1\n3 0 2 3 1 1 1 1\n"));
}

TEST(InputStreams, OffRefusesColoursThatMayBeFaces) {
  // Two triangles, the first of colour 4; or a triangle and the quadrilateral 3 1 2 4.
  const std::string five = "OFF\n5 2 0\n" + square + "2 2 0\n";
  expect_refused([&] { read_bytes("s.off", five + "3 0 1 2 4\n3 1 2 4\n"); }, InputFault::syntax, "more than one way");
  EXPECT_EQ(read_bytes("s.off", five + "3 0 1 2 4\n3 1 2 3\n").triangles.size(), 2u);  // not 3 1 2 3
  EXPECT_EQ(read_bytes("s.off", five + "3 0 1 2 3\n3 1 2 4\n").triangles.size(), 2u);
}

TEST(InputStreams, BrokenOffIsRefusedByLine) {
  const auto refused = [](const std::string& body, InputFault fault, const std::string& part) {
    SCOPED_TRACE(body);
    expect_refused([&] { read_bytes("s.off", "OFF\n4 2 0\n" + body); }, fault, part);
  };
  const std::string triangle = "3 0 1 2\n";
  refused("0 0 0\n1 0\n1 1 0\n0 1 0\n" + halves, InputFault::syntax, "line 4");
  refused("0 0 0\n1 0\n1 1 0\n0 1 0\n" + halves + triangle, InputFault::syntax, "line 4");
  refused("0 0 0\n1 0 0 7\n1 1 0\n0 1 0\n" + halves, InputFault::syntax, "line 4");
  refused("0 0 0\n1 0 0\n1 1 0\n" + halves, InputFault::syntax, "line 6");
  refused(square + "3 0 1\n3 0 2 3\n", InputFault::syntax, "line 7");
  refused(square + "3 0 1\n3 0 2 3\n" + triangle, InputFault::syntax, "line 7");
  refused(square + "3 0 1 2\n3 0 2\n", InputFault::truncated, "line 8");
  refused(square + "3 0 1 2 2 2\n3 0 2 3\n", InputFault::syntax, "colour");
  refused(square + "3 0 1 2 red\n3 0 2 3\n", InputFault::syntax, "line 7");
  refused(square + "3 0 1 2.5\n3 0 2 3\n", InputFault::syntax, "line 7");
  refused(square + triangle, InputFault::truncated, "1 of 2 faces");
}

TEST(InputStreams, BrokenOffOnOneLineIsRefused) {
  const std::string one_line = "OFF " + wrapped("4 2 0 " + square + halves, 1000);
  expect_square("s.off", one_line);
  expect_refused([&] { read_bytes("s.off", one_line + "7"); }, InputFault::syntax, "all numbers");
  expect_refused([&] { read_bytes("s.off", one_line.substr(0, one_line.size() - 4)); }, InputFault::truncated,
                 "line 1");
}

TEST(InputStreams, BrokenPlyIsRefusedByTheLineWhereItBegins) {
  const auto refused = [](const std::string& body, InputFault fault, const std::string& part) {
    SCOPED_TRACE(body);
    expect_refused([&] { read_bytes("s.ply", ply("4 2", body)); }, fault, part);
  };
  refused("0 0 0 7\n1 0 0\n1 1 0\n0 1 0\n" + halves, InputFault::syntax, "line 10");
  refused("0 0 0\n1 0\n1 1 0\n0 1 0\n" + halves, InputFault::syntax, "line 11");
  refused("0 0 0\n1 0\n1 1 0\n0 1 0\n" + halves + "3 0 1 2\n", InputFault::syntax, "line 11");
  refused(square + "0 0 0\n" + halves, InputFault::syntax, "line 14");
  refused("0 0 0\n1 0 0\n1 1 0\n" + halves, InputFault::syntax, "line 13");
  refused(square + "3 0 1\n3 0 2 3\n", InputFault::syntax, "line 14");
  refused(square + "3 0 1 2\n3 0 2", InputFault::truncated, "line 15");
}

TEST(InputStreams, PlyTakesColoursOnALineOfTheirOwn) {
  const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  expect_square("s.ply", ply("4 2", with(square, "\n255 0 0") + halves, colours));
}

TEST(InputStreams, NumbersThatNobodyUsesMayBeAnything) {
  for (const std::string number : {"1e400", "-1e999", "nan", "-nan(ind)", "inf", "1.#QNAN", "-1.#IND", "1.#INF00",
                                   "-1.#INF", "1.#SNAN0", "-1.#IND0e+000"}) {
    SCOPED_TRACE(number);
    expect_square("s.ply", ply("4 2", with(square, " " + number) + halves, "property float nx\n"));
    expect_square("s.off", "OFF\n4 2 0\n" + with(square, " " + number) + halves);
    EXPECT_EQ(read_bytes("p.xyz", with(square, " " + number)).positions.size(), 4u);
  }
  for (const std::string word : {"abc", "1.#FOO", "1.#IND!", "#IND", "--1", "1e4x"})
    expect_refused([&] { read_bytes("s.ply", ply("4 2", with(square, " " + word) + halves, "property float nx\n")); },
                   InputFault::syntax, word);
}

TEST(InputStreams, NumbersThatAreUsedMustBeFinite) {
  for (const std::string number : {"1.#QNAN", "-1.#IND", "1.#INF", "nan"}) {
    const std::string broken = "0 0 0\n1 0 " + number + "\n1 1 0\n0 1 0\n";
    expect_refused([&] { read_bytes("s.ply", ply("4 2", broken + halves)); }, InputFault::nonfinite, "vertex 1");
    expect_refused([&] { read_bytes("s.off", "OFF\n4 2 0\n" + broken + halves); }, InputFault::nonfinite, "vertex 1");
    expect_refused([&] { read_bytes("p.xyz", broken); }, InputFault::nonfinite, "point 1");
    EXPECT_EQ(read_bytes("p.xyz", broken, {.drop_nonfinite = true}).positions.size(), 3u);
  }
  expect_refused([] { read_bytes("s.ply", ply("4 2", "0 0 1e400\n1 0 0\n1 1 0\n0 1 0\n" + halves)); },
                 InputFault::range, "line 10");
}

}  // namespace
}  // namespace geodrome::testing
