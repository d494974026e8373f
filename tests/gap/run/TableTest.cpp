#include "gap/run/Table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gap/run/Run.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

TEST(Table, aThousandColumnsAndAHundredThousandCharactersInALineAreRead) {
  const test::ScratchFolder scratch;
  std::string header = "c0", line = "0";
  for (int i = 1; i < 1000; ++i) {
    header += "," + std::string(80, 'c') + std::to_string(i);
    line += ",1";
  }
  scratch.write("wide.csv", header + "\n" + line + "\n" + line + "\n");
  EXPECT_EQ(readTable(scratch / "wide.csv").names.size(), 1000U);
}

TEST(Table, moreColumnsOrCharactersAreRefused) {
  const test::ScratchFolder scratch;
  const auto refused = [&](const std::string& text) {
    scratch.write("t.csv", text);
    const std::string what = thrownBy([&] { readTable(scratch / "t.csv"); });
    return what.substr(what.rfind("t.csv"));
  };
  std::string header = "c0";
  for (int i = 1; i < 1025; ++i) header += ",c" + std::to_string(i);
  EXPECT_EQ(refused(header + "\n"), "t.csv:1: more than 1024 columns");
  EXPECT_EQ(refused(std::string(140'000, 'x')), "t.csv:1: the line is longer than 131072 characters");
}

TEST(Table, ofALongTextTheBeginningIsShown) {
  EXPECT_EQ(shownText("pos.LKneePitch"), "pos.LKneePitch");
  const std::string many(25, 'a');
  EXPECT_EQ(shownText(many + "\n\xff\t~~~"), many + "???~~");
  EXPECT_EQ(shownText(std::string(29, 'a')), std::string(29, 'a'));
}

TEST(Table, aNameIsShortAndItsBeginningPrintable) {
  EXPECT_TRUE(canBeName(std::string(190, 'a')));
  EXPECT_FALSE(canBeName(std::string(210, 'a')));
  const std::string many(25, 'a');
  EXPECT_FALSE(canBeName(many + "\t"));
}

/// A table of another program.
Table foreign(const std::string& text, char separator = ',') {
  const test::ScratchFolder scratch;
  scratch.write("t.csv", text);
  return readTable(scratch / "t.csv",
                   {.separator = separator, .missing = {"nan"}, .lists = true, .foreign = true});
}
std::string foreignRefused(const std::string& text, char separator = ',') {
  const std::string what = thrownBy([&] { foreign(text, separator); });
  return what.substr(what.rfind("t.csv"));
}

TEST(Table, decimalCommasAreReadWhereTheSeparatorIsAnother) {
  const Table table = foreign("t;q;w\n0,5;-1,5e-3;nan\n1;;2\n", ';');
  EXPECT_EQ(table.columns[0], (std::vector{0.5, 1.0}));
  EXPECT_EQ(table.columns[1][0], -0.0015);
  EXPECT_TRUE(table.bad.empty());
  EXPECT_EQ(table.notes, std::vector<std::string>{"numbers are read with decimal commas"});
  EXPECT_EQ(foreign("t;q\n0;1,2,3\n1;2\n", ';').bad.size(), 1U);
  EXPECT_EQ(foreign("t;q\n0;1.234,5\n1;2\n", ';').bad.size(), 1U) << "thousands";
  EXPECT_EQ(
      foreignRefused("t;q\n0,5;1\n1;2\n1,5;1.234\n", ';'),
      "t.csv: has a decimal comma in line 2 and a decimal point in line 4; write all numbers in one way");
  EXPECT_EQ(foreignRefused("t;q\n0,5;1\n1;2\n"),
            "t.csv:2: has 2 cells, the header has 1; if cells end with another character, write separator: "
            "\";\" into the map");
}

TEST(Table, commentsAreLeftOut) {
  const Table table = foreign("\xef\xbb\xbf# a logger\nt,q\n0,1\n# a pause, of 2 s\n2,3\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "q"}));
  EXPECT_EQ(table.columns[1], (std::vector{1.0, 3.0}));
  EXPECT_EQ(table.notes, std::vector<std::string>{"lines that begin with # are left out: 2"});
}

TEST(Table, namesInACommentRightAboveTheNumbersAreTheHeader) {
  const Table table = foreign("# a logger\n# t, q\n0,1\n2,3\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "q"}));
  EXPECT_EQ(table.columns[0], (std::vector{0.0, 2.0}));
  EXPECT_EQ(table.notes,
            (std::vector<std::string>{"the names of the columns are those of the comment in line 2",
                                      "lines that begin with # are left out: 1"}));
  EXPECT_EQ(foreign("# of today, at noon\nt,q\n0,1\n2,3\n").names[0], "t");
}

/// A table whose cells may hold lists.
Table withLists(const std::string& text) {
  const test::ScratchFolder scratch;
  scratch.write("t.csv", text);
  return readTable(scratch / "t.csv", {.separator = ',', .missing = {"nan"}, .lists = true});
}
std::string refusedWithLists(const std::string& text) {
  const std::string what = thrownBy([&] { withLists(text); });
  return what.substr(what.rfind("t.csv"));
}

TEST(Table, theNumbersOfListsAreColumns) {
  const Table table = withLists("t,q,n\n0,,1\n1,\"[0.1, 0.2]\",2\n2,\"0.3 0.4\",3\n3,nan,4\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"t", "n", "q[0]", "q[1]"}));
  EXPECT_EQ(table.lists, (std::map<std::string, std::size_t>{{"q", 2}}));
  EXPECT_EQ(table.columns[1], (std::vector<double>{1, 2, 3, 4}));
  EXPECT_TRUE(std::isnan(table.columns[2][0]));
  EXPECT_EQ(table.columns[2][1], 0.1);
  EXPECT_EQ(table.columns[3][2], 0.4);
  EXPECT_TRUE(std::isnan(table.columns[3][3]));
  EXPECT_TRUE(table.bad.empty());
}

TEST(Table, aQuotedListGoesOverSeveralLines) {
  const Table table = withLists("t,q\n0,\"[1 2\n 3]\"\n1,\"[4 5\n 6]\"\n");
  EXPECT_EQ(table.columns.back(), (std::vector<double>{3, 6}));
  EXPECT_EQ(refusedWithLists("t,q\n0,\"[1 2\n3\n"),
            "t.csv:2: the quotes of a cell do not end; close them, or take them out");
  std::string lines = "t,q\n0,\"[1";
  for (int i = 0; i < 1100; ++i) lines += "\n1";
  EXPECT_EQ(refusedWithLists(lines + "]\"\n"),
            "t.csv:2: the quotes of a cell do not end; close them, or take them out");
}

TEST(Table, listsOfAnotherLengthAndOtherCellsInAListsColumnAreBad) {
  const Table table = withLists("t,q,n\n0,[1 2],1\n1,[1 2 3],1\n2,5,[1 2]\n");
  EXPECT_EQ(table.bad.at("q[0]").line, 3U);
  EXPECT_EQ(table.bad.at("q[1]").text, "[1 2 3]");
  EXPECT_EQ(table.bad.at("n").text, "[1 2]");
  for (const auto& column : table.columns) EXPECT_EQ(column.size(), 3U);
}

TEST(Table, aListThatIsTooLongIsNoList) {
  std::string list = "[0";
  for (int i = 1; i < 1100; ++i) list += " 0";
  EXPECT_EQ(withLists("t,q\n0," + list + "]\n1,2\n").bad.count("q"), 1U);
  std::string header = "t", cells = "0";
  for (int i = 0; i < 3; ++i) header += ",q" + std::to_string(i), cells += "," + list.substr(0, 1001) + "]";
  EXPECT_EQ(refusedWithLists(header + "\n" + cells + "\n"),
            "t.csv:2: more than 1024 numbers in the lists of its cells");
}

TEST(Table, aRunsTableHoldsNoLists) {
  const test::ScratchFolder scratch;
  scratch.write("t.csv", "t,q\n0,\"[1, 2]\"\n1,\"[1, 2]\"\n");
  EXPECT_EQ(readTable(scratch / "t.csv").bad.at("q").text, "[1, 2]");
}

}  // namespace
}  // namespace plumbline::gap
