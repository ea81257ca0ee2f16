// SPDX-License-Identifier: MIT
#include "tests/support/input_files.hpp"

// Tables of points as scanners, editors and spreadsheets write them.
namespace geodrome::testing {
namespace {

const std::vector<Vec3> points = {{0.5, 0, 0}, {1, 2, 0}, {0, 1, 3}};

void expect_points(const std::string& name, const std::string& bytes, const std::string& columns = "") {
  SCOPED_TRACE(bytes);
  const Input input = read_bytes(name, bytes, {.columns = columns});
  EXPECT_EQ(input.positions, points);
  EXPECT_FALSE(has_warning(input));
}

void expect_no_points(const std::string& bytes, InputFault fault, const std::string& part) {
  SCOPED_TRACE(bytes);
  expect_refused([&] { read_bytes("p.csv", bytes); }, fault, part);
}

TEST(PointTables, MayBeginWithTheNumberOfTheirPoints) {
  const std::string scan = "0.5 0 0 9 255 0 0\n1 2 0 9 255 0 0\n0 1 3 9 255 0 0\n";
  expect_points("p.pts", "3\n" + scan);
  expect_points("p.pts", "//X Y Z I R G B\n3\n" + scan);
  expect_refused([&] { read_bytes("p.pts", "4\n" + scan); }, InputFault::truncated, "4 points, and 3 follow");
  expect_refused([&] { read_bytes("p.pts", "2\n" + scan); }, InputFault::syntax, "2 points, and 3 follow");
  expect_refused([&] { read_bytes("p.pts", "2\n3\n" + scan); }, InputFault::syntax, "line 2");
}

TEST(PointTables, AreReadByTheNamesAboveThem) {
  expect_points("p.txt", "//X Y Z Intensity\n0.5 0 0 7\n1 2 0 7\n0 1 3 7\n");
  expect_points("p.txt", "# z y x\n0 0 0.5\n0 2 1\n3 1 0\n");
  expect_points("p.csv", "x,y,z\n0.5,0,0\n1,2,0\n0,1,3\n");
  expect_points("p.csv", "\"X\", \"Y\" , \"Z\"\r\n0.5, 0, 0\r\n1, 2, 0\r\n0, 1, 3\r\n");
  expect_points("p.csv", "id;Z;'x';note;y\n1;0;0.5;\"a;b\";0\n2;0;1;;2\n3;3;0;c;1\n");
  expect_points("p.csv", ",x,y,z\n0,0.5,0,0\n1,1,2,0\n2,0,1,3\n");
  expect_points("p.xyz", "Point ID\tX\tY\tZ\n0\t0.5\t0\t0\n1\t1\t2\t0\n2\t0\t1\t3\n");
  EXPECT_TRUE(has_finding(read_bytes("p.xyz", "# a x y z\n5 0 0 1\n5 1 0 1\n"), "columns"));
}

TEST(PointTables, MayBeSeparatedByCommasSemicolonsAndTabs) {
  expect_points("p.csv", "0.5,0,0\n1,2,0\n0,1,3\n");
  expect_points("p.xyz", "0.5, 0,\t0 # first\n1 ,2, 0\n0, 1 ,3\n");
  expect_points("p.csv", "0.5;0;0;\n1;2;0;\n0;1;3;\n");
  expect_points("p.csv", "x,y,z\n0.5,0,0,\n1,2,0,\n0,1,3,\n");
  expect_points("p.asc", "0.5\t0\t0\n1\t\t2\t0\n0\t1 3\n");
  expect_points("p.csv", "\"0.5\",\"0\",\"0\"\n\"1\",\"2\",\"0\"\n\"0\",\"1\",\"3\"\n");
}

TEST(PointTables, TakeTheColumnsThatAreChosen) {
  const std::string labelled = "P1 0.5 0 0\nP2 1 2 0\nP3 0 1 3\n";
  expect_points("p.xyz", labelled, "2,3,4");
  expect_points("p.xyz", "3\n" + labelled, "2, 3, 4");
  expect_points("p.csv", "h,E,N\n0,0.5,0\n0,1,2\n3,0,1\n", "e,n,H");
  expect_points("p.csv", "x,y,z\n0,0,0.5\n0,2,1\n3,1,0\n", "3,2,1");
  expect_points("p.csv", "x,y,z,X,Y,Z\n9,9,9,0.5,0,0\n9,9,9,1,2,0\n9,9,9,0,1,3\n", "X,Y,Z");
  expect_points("p.txt", "# h E N\n0 0.5 0\n0 1 2\n3 0 1\n", "E,N,h");
}

TEST(PointTables, RefuseColumnsThatAreNotThere) {
  const auto refused = [](const std::string& bytes, const std::string& columns) {
    try {
      read_bytes("p.xyz", bytes, {.columns = columns});
      return std::string("accepted");
    } catch (const OptionError& error) {
      return std::string(error.what());
    }
  };
  const std::string three = "1 2 3\n4 5 6\n";
  EXPECT_NE(refused(three, "2,3,4").find("no column 4"), std::string::npos);
  EXPECT_NE(refused(three, "0,1,2").find("no column 0"), std::string::npos);
  EXPECT_NE(refused(three, "a,b,c").find("'a'"), std::string::npos);
  EXPECT_NE(refused("# a b b\n" + three, "a,b,1").find("'b'"), std::string::npos);
  EXPECT_NE(refused("# a b c\n" + three, "a,b,1").find("one column"), std::string::npos);
  for (const std::string columns : {"1,2", "1,2,3,4", "1,1,2", "1,,2", ","})
    EXPECT_NE(refused(three, columns).find("three different columns"), std::string::npos) << columns;
  expect_refused([] { read_bytes("m.off", "OFF\n1 0 0\n0 0 0\n", {.columns = "1,2,3"}); }, InputFault::unsupported,
                 "tables of points");
}

TEST(PointTables, RefuseNamesThatDoNotTell) {
  expect_no_points("E,N,h\n1,2,3\n", InputFault::unsupported, "read.columns");
  expect_no_points("x,y,x\n1,2,3\n", InputFault::unsupported, "once each");
  expect_no_points("x,y,z,i\n1,2,3\n", InputFault::syntax, "names 4 columns");
  expect_no_points("# z y x\n1 2 3 4\n", InputFault::syntax, "line 1 names 3 columns");
  expect_no_points("x,y,z\nx,y,z\n1,2,3\n", InputFault::syntax, "'x' is no number");
  EXPECT_TRUE(has_finding(read_bytes("p.xyz", "# id x y z\n5 0 0 1 7\n5 1 0 1 7\n"), "column_names_not_used"));
  EXPECT_FALSE(has_warning(read_bytes("p.xyz", "# a torus\n# x y z and the normal\n0 0 1 7\n5 1 0 1\n")));
}

TEST(PointTables, RefuseDecimalCommas) {
  expect_no_points("1,5;2,0;3,0\n1,6;2,0;3,0\n", InputFault::syntax, "decimal points");
  expect_no_points("x;y;z\n1,5;2,0;3,0\n", InputFault::syntax, "decimal points");
  expect_no_points("1,5 2,0 3,0\n", InputFault::syntax, "decimal points");
  expect_no_points("1,5\t2,0\t3,0\n", InputFault::syntax, "decimal points");
  expect_no_points("1,5, 2,0, 3,0\n", InputFault::unsupported, "decimal points");
  expect_no_points("x y z id\n1,5 2,0 3,0 7\n", InputFault::syntax, "decimal points");
  expect_no_points("x,y,z\n1,5,2,0,3,0\n", InputFault::syntax, "names 3 columns");
}

TEST(PointTables, RefuseWhatIsNoTable) {
  expect_no_points("1,2,3\n1,2\n", InputFault::syntax, "line 2");
  expect_no_points("1,2,3\n1,,3\n", InputFault::syntax, "column 2 is empty");
  expect_no_points("1,2,3,a\n", InputFault::syntax, "'a' is no number");
  expect_no_points("3\nwater\nO 0 0 0.1\nH 0 1 0\nH 1 0 0\n", InputFault::syntax, "water");
  expect_no_points("x,y,z\n", InputFault::empty, "no points");
}

TEST(PointTables, NoticeAnIndexInTheFirstColumn) {
  for (const std::string bytes : {"0 5 0 1\n1 5 2 1\n2 0 1 3\n", "1,5,0,1,9\n2,5,2,1,9\n3,0,1,3,9\n"}) {
    expect_no_points(bytes, InputFault::unsupported, "first column counts");
    EXPECT_EQ(read_bytes("p.csv", bytes, {.columns = "2,3,4"}).positions[0], (Vec3{5, bytes[4] - 48., 1}));
    EXPECT_EQ(read_bytes("p.csv", bytes, {.columns = "1,2,3"}).positions.size(), 3u);
  }
  EXPECT_FALSE(has_warning(read_bytes("p.xyz", "0 0 0 1\n1 0 0 1\n2 0 0 1\n0 1 0 1\n")));  // a grid
  EXPECT_FALSE(has_warning(read_bytes("p.xyz", "# x y z w\n0 5 0 1\n1 5 2 1\n2 0 1 3\n")));
  EXPECT_TRUE(has_finding(read_bytes("p.xyz", "0 5 0\n1 5 2\n2 0 1\n"), "first_column_counts"));
}

}  // namespace
}  // namespace geodrome::testing
