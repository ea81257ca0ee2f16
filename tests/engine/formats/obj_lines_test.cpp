// SPDX-License-Identifier: MIT
#include "tests/support/input_files.hpp"

// A backslash at the end of a line of OBJ: a continuation, the end of a comment, or part of a name.
namespace geodrome::testing {
namespace {

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Input read_obj(const std::string& bytes) {
  SCOPED_TRACE(bytes);
  const Input input = read_bytes("s.obj", bytes);
  EXPECT_EQ(input.positions.size(), 4u);
  EXPECT_EQ(input.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  return input;
}

std::string with_crlf(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.insert(at, 1, '\r');
  return text;
}

TEST(ObjLines, CommentsEndWithTheirLine) {
  for (const std::string& bytes :
       {"# C:\\models\\\n" + vertices + "f 1 2 3\n# end \\\nf 1 3 4\n",
        std::string("v 0 0 0 # first \\\nv 1 0 0\nv 1 1 0\nv 0 1 0#\\\nf 1 2 3 # \\\nf 1 3 4\n")}) {
    EXPECT_FALSE(has_warning(read_obj(bytes)));
    EXPECT_FALSE(has_warning(read_obj(with_crlf(bytes))));
  }
}

TEST(ObjLines, NamesSwallowNoVertexAndNoFace) {
  for (const std::string name : {"g a", "o a", "usemtl a", "mtllib C:\\a", "s 1 ", "usemap a", "vn 0 0 1 ", "vt 0 0"}) {
    const std::string bytes = name + "\\\n" + vertices + name + "\\\nf 1 2 3\n" + name + "\\  \nf 1 3 4\n";
    EXPECT_TRUE(has_finding(read_obj(bytes), "backslash_joins_nothing")) << name;
    EXPECT_TRUE(has_finding(read_obj(with_crlf(bytes)), "backslash_joins_nothing")) << name;
  }
  EXPECT_FALSE(has_warning(read_obj(vertices + "g a\\\no b\nf 1 2 3\nf 1 3 4\n")));
}

TEST(ObjLines, ContinuationsJoinNumbers) {
  for (const std::string& bytes :
       {vertices + "f 1 2 \\\n3\nf 1\\\n3\\\n4\n", vertices + "f 1 2 \\  \n  3\nf 1 \\\t\n3 4\n",
        std::string("v 0 \\\n0\\\n-0\nv 1 0 +0\nv 1 1 \\\n.0\nv 0 1 0\nf -4 -3 \\\n-2\nf 1/1 3/3\\\n 4/4\n"),
        vertices + "f 1 2 3\nf 1 3 4\\", vertices + "f 1 2 3\nf 1 3 4 \\\n\n"}) {
    EXPECT_FALSE(has_warning(read_obj(bytes)));
    EXPECT_FALSE(has_warning(read_obj(with_crlf(bytes))));
  }
}

TEST(ObjLines, FacesAsTheFirstVersionsWroteThemAreFaces) {
  const Input input = read_obj(vertices + "fo 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(input.triangles.size(), 2u);
  EXPECT_FALSE(has_warning(input));
}

TEST(ObjLines, RecordsOfNoKindAreTold) {
  const Input input = read_obj(vertices + "vn 0 0 1\nusemtl a\nf 1 2 3\nF 1 3 4\nface 1 3 4\nf 1 3 4\n");
  ASSERT_TRUE(has_finding(input, "unknown_records"));
  EXPECT_EQ(input.findings[0].count, 2u);
  EXPECT_NE(input.findings[0].message.find("'F' in line 8"), std::string::npos) << input.findings[0].message;
}

TEST(ObjLines, ContinuationsWithinOtherRecordsAreJoined) {
  const Input input = read_obj(vertices + "l 1 2 \\\n3 4\np 1\\\n 2\nvp 0 \\\n1\nf 1 2 3\nf 1 3 4\n");
  ASSERT_TRUE(has_finding(input, "ignored_records"));
  EXPECT_EQ(input.findings[0].count, 2u);
}

TEST(ObjLines, ContinuationsOfNothingAreRefusedByLine) {
  for (const std::string faces :
       {"f 1 2 \\\nf 1 3 4\n", "f 1 2 3 \\\nf 1 3 4\n", "f 1 2 \\\n# c\n3\n", "f 1 2 \\\n\n3\n"})
    expect_refused([&] { read_bytes("s.obj", vertices + faces); }, InputFault::syntax, "line 5");
  expect_refused([] { read_bytes("s.obj", "v 0 0 \\\nv 1 0 0\n"); }, InputFault::syntax, "line 1");
}

}  // namespace
}  // namespace geodrome::testing
