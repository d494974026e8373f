#include "web/DecisionFiles.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::web {
namespace {

using nlohmann::json;

const std::string header = "clock,x,y,action1,endX1,endY1,value1,goal1,action2,endX2,endY2,value2,goal2\n";

class DecisionFilesTest : public ::testing::Test {
protected:
  json read() { return json::parse(gameDecisions(folder / "")); }
  /// What is wrong with a file that has these lines; without the folder.
  std::string problem(const std::string& lines, const std::string& before = header) {
    folder.write("left-7.csv", before + lines);
    const std::string said = thrownBy([&] { gameDecisions(folder / ""); });
    const std::size_t file = said.find("left-7.csv");
    return file == std::string::npos ? said : said.substr(file);
  }
  test::ScratchFolder folder;
};

TEST_F(DecisionFilesTest, readsAllPlayersAndTurnsTheRightTeamsPlaces) {
  folder.write("left-7.csv",
               header + "12.5,1,2,kickLong,9,2.5,0.4,0.25,dribble,2,2,-0.1,0\n13,1,2,dribble,2,2,0,0,,,,,\n");
  folder.write("right-11.csv", header + "20,1,-2,dribble,2,0,0.5,1,,,,,\n");
  folder.write("left-12.csv", "not a player's");
  folder.write("notes.txt", "nor this");
  const json all = read();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["side"], "left");
  EXPECT_EQ(all[0]["unum"], 7);
  EXPECT_EQ(all[0]["lines"].dump(),
            R"([[12.5,1.0,2.0,[["kickLong",9.0,2.5,0.4,0.25],["dribble",2.0,2.0,-0.1,0.0]]],)"
            R"([13.0,1.0,2.0,[["dribble",2.0,2.0,0.0,0.0]]]])");
  EXPECT_EQ(all[1]["side"], "right");
  EXPECT_EQ(all[1]["lines"].dump(), R"([[20.0,-1.0,2.0,[["dribble",-2.0,0.0,0.5,1.0]]]])");
}

TEST_F(DecisionFilesTest, aLineThatWasCutOffIsLeftOut) {
  folder.write("left-7.csv", header + "12,1,2,dribble,2,2,0,0,,,,,\n13,1,2,dri");
  EXPECT_EQ(read()[0]["lines"].size(), 1u);
  folder.write("left-7.csv", header);
  EXPECT_EQ(read()[0]["lines"].size(), 0u);
}

TEST_F(DecisionFilesTest, eachNumberIsChecked) {
  EXPECT_EQ(problem("12,1,nan,dribble,2,2,0,0,,,,,\n"),
            "left-7.csv:2: \"nan\" is no number from -1000 to 1000");
  EXPECT_EQ(problem("-1,1,2,dribble,2,2,0,0,,,,,\n"), "left-7.csv:2: \"-1\" is no number from 0 to 1e+06");
  EXPECT_EQ(problem("1,1,2,dribble,1e300,2,0,0,,,,,\n"),
            "left-7.csv:2: \"1e300\" is no number from -1000 to 1000");
  EXPECT_EQ(problem("1,1,2,dribble,2,2,11,0,,,,,\n"), "left-7.csv:2: \"11\" is no number from -10 to 10");
  EXPECT_EQ(problem("1,1,2,dribble,2,2,0,1.5,,,,,\n"), "left-7.csv:2: \"1.5\" is no number from 0 to 1");
  EXPECT_EQ(problem("1,1,2,dribble,2,2m,0,0,,,,,\n"), "left-7.csv:2: \"2m\" is no number from -1000 to 1000");
  EXPECT_EQ(problem("1,,2,dribble,2,2,0,0,,,,,\n"), "left-7.csv:2: \"\" is no number from -1000 to 1000");
  EXPECT_EQ(problem("1,1,2,dribble,2,2,0,0,,,,,\n2,1,2,dribble,2,2,0,0,kick,inf,2,0,0\n"),
            "left-7.csv:3: \"inf\" is no number from -1000 to 1000");
}

TEST_F(DecisionFilesTest, otherFilesAreErrorsWithTheirPlace) {
  EXPECT_EQ(problem("1,1,2,drib ble,2,2,0,0,,,,,\n"), "left-7.csv:2: \"drib ble\" is no action");
  EXPECT_EQ(problem("1,1,2,<script>,2,2,0,0,,,,,\n"), "left-7.csv:2: \"<script>\" is no action");
  EXPECT_EQ(problem("1,1,2," + std::string(41, 'a') + ",2,2,0,0,,,,,\n"),
            "left-7.csv:2: \"" + std::string(40, 'a') + "\" is no action");
  EXPECT_EQ(problem("1,1,2,,2,2,0,0,,,,,\n"), "left-7.csv:2: no action");
  EXPECT_EQ(problem("1,1,2,dribble\n"), "left-7.csv:2: 4 columns, not 13");
  EXPECT_EQ(problem(std::string(2000, '1') + "\n"), "left-7.csv:2: the line is too long");
  EXPECT_EQ(problem("", ""), "left-7.csv:1: this is no file of bin/agent --decisions");
  EXPECT_EQ(problem("", "time,kick,foot\n"), "left-7.csv:1: this is no file of bin/agent --decisions");
  EXPECT_EQ(problem(std::string("\0\n\xff\n", 4)).substr(0, 13), "left-7.csv:2:");
  EXPECT_EQ(problem(std::string(9 << 20, 'a')), "left-7.csv: is larger than 8 MB");
}

TEST_F(DecisionFilesTest, aFolderWithoutFilesIsAnError) {
  folder.write("empty/notes.txt", "");
  EXPECT_EQ(thrownBy([&] { gameDecisions(folder / "empty"); }),
            folder / "empty" + ": no decisions are in it; bin/agent --decisions " + folder / "empty" +
                " writes them");
  EXPECT_NE(thrownBy([&] { gameDecisions(folder / "nowhere"); }).find("no decisions are in it"),
            std::string::npos);
}

}  // namespace
}  // namespace plumbline::web
