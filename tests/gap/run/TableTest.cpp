#include "gap/run/Table.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(shownText(std::string(25, 'a') + "\n\xff\t~~~"), std::string(25, 'a') + "???~~");
  EXPECT_EQ(shownText(std::string(29, 'a')), std::string(29, 'a'));
}

TEST(Table, aNameIsShortAndItsBeginningPrintable) {
  EXPECT_TRUE(canBeName(std::string(190, 'a')));
  EXPECT_FALSE(canBeName(std::string(210, 'a')));
  EXPECT_FALSE(canBeName(std::string(25, 'a') + "\t"));
}

}  // namespace
}  // namespace plumbline::gap
