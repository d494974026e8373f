#include "situation/SituationFile.h"

#include <gtest/gtest.h>

#include "situation/SituationPage.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

/// Most lines of a file that there is.
const std::string strikersFile =
    "about: \"Nobody is near.\"\n"
    "decides: striker\n"
    "robot: [-0.5, 0.0, 0.1]\n"
    "ball: [0.0, 0.25]\n"
    "mates: [[-4, 3, 7], [-5, -3]]\n"
    "velocities: [[0.5, 0]]\n"
    "going: [[-2, 4, 1.5]]\n"
    "opponents: [[9, 1]]\n"
    "kicks: [{reach: 3.4, spread: 0.5, scatter: 90, rise: 0.2}]\n"
    "expected: {action: kick, direction: [-0.7, 0.7], reach: [2, 4]}\n";

struct SituationFileTest : testing::Test {
  Situation read(const std::string& text) const {
    scratch.write("one.yaml", text);
    return readSituation(scratch / "one.yaml");
  }
  /// What is said of a file, without its folder.
  std::string errorOf(const std::string& text) const {
    const std::string what = thrownBy([&] { read(text); });
    const std::string folder = scratch.path() + "/";
    return what.rfind(folder, 0) == 0 ? what.substr(folder.size()) : what;
  }
  /// The same file with a part of it replaced.
  static std::string with(std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
  }
  std::string errorWith(const std::string& part, const std::string& by) const {
    return errorOf(with(strikersFile, part, by));
  }
  test::ScratchFolder scratch;
};

TEST_F(SituationFileTest, readsWhatAStrikerKnows) {
  const Situation s = read(strikersFile);
  EXPECT_EQ(s.about, "Nobody is near.");
  EXPECT_EQ(s.decides, Decider::striker);
  EXPECT_EQ(s.mode, TeamPlayMode::playOn);
  EXPECT_EQ(s.robot.position, Vec2(-0.5, 0));
  EXPECT_EQ(s.robot.heading, 0.1);
  EXPECT_EQ(s.ball, Vec2(0, 0.25));
  ASSERT_EQ(s.others.size(), 3u);
  EXPECT_TRUE(s.others[0].mate);
  EXPECT_EQ(s.others[0].number, 7);
  EXPECT_EQ(s.others[0].velocity, Vec2(0.5, 0));
  EXPECT_EQ(s.others[1].number, 0);
  EXPECT_FALSE(s.others[2].mate);
  EXPECT_EQ(s.others[2].position, Vec2(9, 1));
  ASSERT_EQ(s.going.size(), 1u);
  EXPECT_EQ(s.going[0].number, 7);
  EXPECT_EQ(s.going[0].place.position, Vec2(-2, 4));
  EXPECT_EQ(s.going[0].heading, 1.5);
  ASSERT_EQ(s.kicks.size(), 1u);
  EXPECT_EQ(s.kicks[0].distance, 3.4);
  EXPECT_NEAR(s.kicks[0].scatter, pi / 2, 1e-12) << "degrees in the file";
  const auto& expected = std::get<StrikerExpected>(s.expected);
  EXPECT_EQ(expected.action, StrikerExpected::Action::kick);
  EXPECT_EQ(expected.direction, Vec2(-0.7, 0.7));
  EXPECT_EQ(*expected.reach, Vec2(2, 4));
}

TEST_F(SituationFileTest, aPlayersPlaceInTheFormationIsWhatItSaid) {
  const Situation s = read(
      "about: x\ndecides: formation\nmode: kickOffOwn\nball: [0, 0]\nplayer: 3\n"
      "team: [[1, -14, 0, 0, 14], [3, -6, 1, 0.5, 7]]\nexpected: {striker: 3, role: striker}\n");
  EXPECT_EQ(s.mode, TeamPlayMode::kickOffOwn);
  EXPECT_EQ(s.player, 3);
  EXPECT_EQ(s.robot.position, Vec2(-6, 1));
  ASSERT_EQ(s.team.size(), 2u);
  EXPECT_EQ(s.team[1].timeToBall, 7);
}

TEST_F(SituationFileTest, allOfTheTestsReadBackAsTheyWereWritten) {
  for (const SituationEntry& entry : situationsIn("tests/data/situations")) {
    const std::string text = situationText(entry.situation);
    EXPECT_EQ(situationText(read(text)), text) << entry.file;
    EXPECT_NE(entry.situation.expected.index(), 0u) << entry.file << " has nothing that is expected";
  }
}

TEST_F(SituationFileTest, whatIsExpectedMayBeMissing) {
  EXPECT_EQ(read("about: x\ndecides: block\nball: [0, 0]\n").expected.index(), 0u);
}

TEST_F(SituationFileTest, quotesInTheWordsAreWritten) {
  Situation s;
  s.decides = Decider::block;
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
  EXPECT_EQ(errorWith("[[-2, 4, 1.5]]", "[[1, 1, 1], [2, 2, 2], [3, 3, 3]]"),
            "one.yaml:7: going must have one for each mate, 2 at most, not 3");
  EXPECT_EQ(errorWith("direction: [-0.7, 0.7]", "direction: [0.7, -0.7]"),
            "one.yaml:10: expected.direction must be [from, to] with the smaller one first, not [0.7, -0.7]");
}

TEST_F(SituationFileTest, anUnknownKeyIsNamedWithTheNearest) {
  EXPECT_EQ(errorWith("opponents:", "oponents:"),
            "one.yaml:8: unknown key \"oponents\"; did you mean \"opponents\"?");
  EXPECT_EQ(errorWith("action: kick", "action: kick, reech: [1, 2]"),
            "one.yaml:10: unknown key \"expected.reech\"; did you mean \"reach\"?");
  EXPECT_EQ(
      errorOf("about: x\ndecides: goalie\nrobot: [0, 0, 0]\nball: [0, 0]\nvelocity: [0, 0]\nkicks: []\n")
          .substr(0, 31),
      "one.yaml:6: unknown key \"kicks\"")
      << "a goalie has no kicks";
}

TEST_F(SituationFileTest, whatIsTooMuchIsRefused) {
  std::string many = "[0, 0]";
  for (int i = 0; i < 11; ++i) many += ", [0, 0]";
  EXPECT_EQ(errorWith("[9, 1]", many), "one.yaml:8: opponents must have 11 at most, not 12");
  EXPECT_EQ(errorWith("Nobody is near.", std::string(401, 'a')),
            "one.yaml:1: about must have 400 characters at most, not 401");
}

TEST_F(SituationFileTest, thePlayerOfAFormationIsOneOfTheTeam) {
  EXPECT_EQ(errorOf("about: x\ndecides: formation\nball: [0, 0]\nplayer: 4\nteam: [[1, 0, 0, 0, 1]]\n"),
            "one.yaml:4: player must be one of the team's, not 4: its place is there");
}

}  // namespace
}  // namespace plumbline
