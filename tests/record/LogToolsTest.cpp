#include <gtest/gtest.h>

#include <sstream>

#include "record/ExampleLog.h"
#include "record/LogCompare.h"
#include "record/LogCopy.h"
#include "record/LogReader.h"
#include "record/LogTable.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::record {
namespace {

struct LogToolsTest : testing::Test {
  test::ScratchFolder scratch;
  std::string game = scratch / "game";
  LogToolsTest() { writeExampleLog(game, 1, 300); }
};

TEST_F(LogToolsTest, partsJoinedAreTheWhole) {
  EXPECT_EQ(cutLog(game, scratch / "a", {.to = 2}), 100u);
  EXPECT_EQ(cutLog(game, scratch / "b", {.firstCycle = 101}), 200u);
  EXPECT_EQ(joinLogs({scratch / "a", scratch / "b"}, scratch / "ab"), 300u);
  const LogComparison same = compareLogs(game, scratch / "ab", {}, 0);
  EXPECT_TRUE(same.same());
  EXPECT_EQ(same.compared, 300u);
  EXPECT_EQ(LogReader(scratch / "ab").thread("").missing(), 0u);
}

TEST_F(LogToolsTest, whatDoesNotFollowIsJoinedBehindAMissingCycle) {
  EXPECT_EQ(joinLogs({game, game}, scratch / "twice"), 600u);
  const LogReader log(scratch / "twice");
  EXPECT_EQ(log.thread("").missing(), 1u);
  EXPECT_EQ(log.thread("").cycles.at(300).number, 302u);
  EXPECT_EQ(log.thread("").cycles.at(300).timestamp - log.thread("").cycles.at(299).timestamp, 20'000'000);
}

TEST_F(LogToolsTest, logsOfOtherThingsAreNotJoined) {
  cutLog(game, scratch / "counter", {.only = {"Counter"}});
  const std::string counter = scratch / "counter";
  EXPECT_EQ(thrownBy([&] {
              joinLogs({game, counter}, scratch / "x");
            }),
            counter + " cannot be appended to " + game + ": it has no Shapes");
  EXPECT_EQ(thrownBy([&] {
              joinLogs({counter, game}, scratch / "x");
            }),
            game + " cannot be appended to " + counter + ": it has more representations");
  EXPECT_FALSE(std::filesystem::exists(scratch / "x"));
}

TEST_F(LogToolsTest, aPartWithNothingInItLeavesNothingBehind) {
  EXPECT_EQ(thrownBy([&] { cutLog(game, scratch / "x", {.from = 100}); }),
            game + " has no cycle in that part");
  EXPECT_EQ(thrownBy([&] { cutLog(game, scratch / "x", {.only = {"Conter"}}); }),
            game + " has no Conter; did you mean \"Counter\"?");
  EXPECT_FALSE(std::filesystem::exists(scratch / "x"));
}

TEST_F(LogToolsTest, theFirstDifferenceOfEachRepresentationIsNamed) {
  LogWriter writer(scratch / "other", {});
  writer.begin({exampleThread()});
  for (int number = 1; number <= 301; ++number) {
    auto messages = exampleMessages(number);
    if (number >= 200) messages[0] = exampleMessages(number + 1)[0];
    if (number == 150) messages[1] = exampleMessages(153)[1];
    writer.write({0,
                  static_cast<std::uint64_t>(number),
                  number * std::int64_t{20'000'000},
                  {messages.begin(), messages.end()}});
  }
  writer.finish();
  const LogComparison found = compareLogs(game, scratch / "other", {}, 0);
  ASSERT_EQ(found.differences.size(), 2u);
  EXPECT_EQ(found.differences[0].representation + found.differences[0].field, "Shapes.number");
  EXPECT_EQ(found.differences[0].cycle, 150u);
  EXPECT_EQ(found.differences[0].cycles, 1u);
  EXPECT_EQ(found.differences[1].representation + found.differences[1].field, "Counter.value");
  EXPECT_EQ(found.differences[1].cycle, 200u);
  EXPECT_EQ(found.differences[1].time, 4.0);
  EXPECT_EQ(found.differences[1].left, "200");
  EXPECT_EQ(found.differences[1].right, "201");
  EXPECT_EQ(found.differences[1].cycles, 101u);
  EXPECT_EQ(found.onlyRight, 1u);
  EXPECT_TRUE(compareLogs(game, scratch / "other", {"Counter"}, 1).differences.empty());
}

TEST_F(LogToolsTest, tablesHaveAColumnForEachNumberAndOneForAList) {
  LogReader log(game);
  const LogReader::Thread& thread = log.thread("");
  std::ostringstream out;
  EXPECT_EQ(writeCsv(log, thread,
                     logColumns(log, thread, {"Counter", "Shapes.angles[1]", "Shapes.names", "Shapes.text"}),
                     {.firstCycle = 5, .lastCycle = 6}, out),
            2u);
  EXPECT_EQ(out.str(),
            "time,cycle,Counter.value,Shapes.text,Shapes.angles[1],Shapes.names\n"
            "0.1,5,5,none,2,a b\n"
            "0.12,6,6,none,2,a b a b\n");
  EXPECT_EQ(logColumns(log, thread, {}).size(), 1u + 4 + 2 + 3 + 2);
  EXPECT_EQ(thrownBy([&] { logColumns(log, thread, {"Shapes.place.z"}); }),
            game + " has no Shapes.place.z; did you mean \"Shapes.place.x\"?");
}

}  // namespace
}  // namespace plumbline::record
