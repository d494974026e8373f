#include "situation/SituationFile.h"

#include <gtest/gtest.h>

#include "situation/SituationKinds.h"
#include "situation/SituationPage.h"
#include "support/SituationReading.h"

namespace plumbline {
namespace {

struct SituationFileTest : test::SituationReading {};

TEST_F(SituationFileTest, readsWhereEverybodyIs) {
  const Situation s = read(test::strikersFile);
  EXPECT_EQ(s.about, "Nobody is near.");
  EXPECT_EQ(s.kind, &situationKind("striker"));
  EXPECT_EQ(s.mode, TeamPlayMode::playOn);
  EXPECT_EQ(s.robot.position, Vec2(-0.5, 0));
  EXPECT_EQ(s.robot.heading, 0.1);
  EXPECT_EQ(s.ball, Vec2(0, 0.25));
  ASSERT_EQ(s.others.size(), 3u);
  EXPECT_TRUE(s.others[0].mate);
  EXPECT_EQ(s.others[0].number, 7);
  EXPECT_EQ(s.others[1].number, 0);
  EXPECT_FALSE(s.others[2].mate);
  EXPECT_EQ(s.others[2].position, Vec2(9, 1));
}

TEST_F(SituationFileTest, allOfTheTestsReadBackAsTheyWereWritten) {
  for (const SituationEntry& entry : situationsIn("tests/data/situations")) {
    const std::string text = situationText(entry.situation);
    EXPECT_EQ(situationText(read(text)), text) << entry.file;
    EXPECT_TRUE(entry.situation.expected) << entry.file << " has nothing that is expected";
  }
}

TEST_F(SituationFileTest, whatIsExpectedMayBeMissing) {
  EXPECT_FALSE(read("about: x\ndecides: block\nball: [0, 0]\n").expected);
}

TEST_F(SituationFileTest, quotesInTheWordsAreWritten) {
  Situation s;
  s.kind = &situationKind("block");
  s.about = "\"so\" \\ it\nis";
  EXPECT_EQ(read(situationText(s)).about, "\"so\" \\ it is");
}

TEST_F(SituationFileTest, anErrorNamesFileLineAndKey) {
  EXPECT_EQ(
      errorWith("decides: striker", "decides: keeper"),
      "one.yaml:2: decides must be striker, goalie, formation, supporter, block, setPiece or passCall, not "
      "\"keeper\"");
  EXPECT_EQ(errorWith("ball: [0.0, 0.25]\n", ""), "one.yaml:1: missing key \"ball\"");
  EXPECT_EQ(errorWith("[0.0, 0.25]", "[0.0]"), "one.yaml:4: ball must be a list of 2, not a list of 1");
  EXPECT_EQ(errorWith("[0.0, 0.25]", "[0.0, 101]"),
            "one.yaml:4: ball[1] must be within [-100, 100], not 101");
  EXPECT_EQ(errorWith("[-4, 3, 7]", "[-4]"),
            "one.yaml:5: mates must be a list of [x, y] or [x, y, number]; number 1 of it has 1 values");
  EXPECT_EQ(errorWith("[-4, 3, 7]", "[-4, 3, 1.5]"),
            "one.yaml:5: mates has 1.5 where a player's number from 0 (not known) to 11 must be");
}

TEST_F(SituationFileTest, anUnknownKeyIsNamedWithTheNearest) {
  EXPECT_EQ(errorWith("opponents:", "oponents:"),
            "one.yaml:8: unknown key \"oponents\"; did you mean \"opponents\"?");
  EXPECT_EQ(errorWith("action: kick", "action: kick, reech: [1, 2]"),
            "one.yaml:10: unknown key \"expected.reech\"; did you mean \"reach\"?");
}

TEST_F(SituationFileTest, whatIsTooMuchIsRefused) {
  std::string many = "[0, 0]";
  for (int i = 0; i < 11; ++i) many += ", [0, 0]";
  EXPECT_EQ(errorWith("[9, 1]", many), "one.yaml:8: opponents must have 11 at most, not 12");
  EXPECT_EQ(errorWith("Nobody is near.", std::string(401, 'a')),
            "one.yaml:1: about must have 400 characters at most, not 401");
}

}  // namespace
}  // namespace plumbline
