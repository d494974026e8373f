#include "gap/run/Cell.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::gap {
namespace {

using Cells = std::vector<std::string_view>;
using Numbers = std::vector<double>;

Cells cellsOf(std::string_view line, bool lists = true, char separator = ',') {
  Cells cells;
  EXPECT_TRUE(splitCells(line, separator, lists, cells));
  return cells;
}

/// The list in a cell; a text that is none gives {-1}.
Numbers listIn(std::string_view text, std::size_t longest = 100) {
  Numbers list;
  return listOf(text, {"nan"}, longest, list) ? list : Numbers{-1};
}

TEST(Cell, aSeparatorWithinQuotesDoesNotSplit) {
  EXPECT_EQ(cellsOf("1, \"2,3\" ,4"), (Cells{"1", "2,3", "4"}));
  EXPECT_EQ(cellsOf("\"a\"\"b,\",4", false), (Cells{"a\"\"b,", "4"}));
  EXPECT_EQ(cellsOf("5\",6"), (Cells{"5\"", "6"}));
  EXPECT_EQ(cellsOf(",\"\","), (Cells{"", "", ""}));
  EXPECT_EQ(cellsOf("1\t\"2\t3\"", true, '\t'), (Cells{"1", "2\t3"}));
}

TEST(Cell, bracketsHoldAListTogether) {
  EXPECT_EQ(cellsOf("1,[2, 3],4"), (Cells{"1", "[2, 3]", "4"}));
  EXPECT_EQ(cellsOf("1,[2, 3],4", false), (Cells{"1", "[2", "3]", "4"}));
  EXPECT_EQ(cellsOf("1,[2, 3"), (Cells{"1", "[2", "3"}));
}

TEST(Cell, quotesThatStayOpenAreSeenWhereListsMayBe) {
  Cells cells;
  EXPECT_FALSE(splitCells("1,\"[2,", ',', true, cells));
  EXPECT_TRUE(splitCells("1,\"[2,", ',', false, cells));
  EXPECT_EQ(cells, (Cells{"1", "\"[2", ""}));
}

TEST(Cell, listsAsProgramsWriteThem) {
  for (const char* text : {"[0.1, -2, 3e1]", "(0.1, -2, 3e1)", "[0.1 -2 3e1]", "0.1 -2 3e1", "0.1;-2;3e1",
                           "array([0.1, -2, 3e1])", "array('d', [0.1, -2, 3e1])",
                           "array([0.1, -2, 3e1], dtype=float32)", "[ 0.1 -2.\n 3e1]"})
    EXPECT_EQ(listIn(text), (Numbers{0.1, -2, 30})) << text;
  EXPECT_EQ(listIn("[7]"), Numbers{7});
  EXPECT_EQ(listIn("[]"), Numbers{});
  EXPECT_TRUE(std::isnan(listIn("[1, nan]")[1]));
}

TEST(Cell, otherTextsAreNoLists) {
  for (const char* text : {"7", "1,5", "a b", "[1, inf]", "[[1, 2]]", "[1, 2", "1, 2]", "array([1, 2]",
                           "(1, 2]", "2026-03-01 12:00:00", "array(", "[", "", "\"", "[1, 1e999]"})
    EXPECT_EQ(listIn(text), Numbers{-1}) << text;
  EXPECT_EQ(listIn("[1, 2, 3]", 2), Numbers{-1});
}

}  // namespace
}  // namespace plumbline::gap
