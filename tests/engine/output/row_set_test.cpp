// SPDX-License-Identifier: MIT
#include "geodrome/engine/row_set.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

std::vector<std::uint64_t> listed(const RowSet& rows) {
  std::vector<std::uint64_t> list;
  for (std::uint64_t i = 0; i < rows.size(); ++i) list.push_back(rows[i]);
  return list;
}

TEST(RowSet, ListsAllRowsARangeOrEveryNth) {
  using Rows = std::vector<std::uint64_t>;
  EXPECT_EQ(listed(RowSet::all(3)), (Rows{0, 1, 2}));
  EXPECT_EQ(listed(RowSet::range(4, 7)), (Rows{4, 5, 6}));
  EXPECT_EQ(listed(RowSet::part(1, 3, 8)), (Rows{1, 4, 7}));
  EXPECT_EQ(listed(RowSet::part(2, 3, 8)), (Rows{2, 5}));
}

TEST(RowSet, MayBeEmpty) {
  EXPECT_EQ(RowSet::all(0).size(), 0U);
  EXPECT_EQ(RowSet::range(5, 5).size(), 0U);
  EXPECT_EQ(RowSet::part(6, 7, 3).size(), 0U);
}

TEST(RowSet, PartsCoverEveryRowOnce) {
  for (const std::uint64_t rows : {0, 1, 6, 7, 8, 100})
    for (const std::uint64_t parts : {1, 2, 7, 200}) {
      std::vector<int> covered(rows, 0);
      for (std::uint64_t part = 0; part < parts; ++part)
        for (const std::uint64_t row : listed(RowSet::part(part, parts, rows))) ++covered.at(row);
      EXPECT_EQ(covered, std::vector<int>(rows, 1)) << rows << " rows, " << parts << " parts";
    }
}

TEST(RowSet, ContainsWhatItLists) {
  for (const RowSet& set : {RowSet::all(9), RowSet::range(2, 6), RowSet::part(1, 3, 9), RowSet::part(5, 6, 3)}) {
    std::vector<std::uint64_t> contained;
    for (std::uint64_t row = 0; row < 20; ++row)
      if (set.contains(row)) contained.push_back(row);
    EXPECT_EQ(contained, listed(set));
  }
}

TEST(RowSet, RefusesWhatIsNoSet) {
  EXPECT_THROW(RowSet::range(3, 2), OptionError);
  EXPECT_THROW(RowSet::part(3, 3, 10), OptionError);
  EXPECT_THROW(RowSet::part(0, 0, 10), OptionError);
}

}  // namespace
}  // namespace geodrome
