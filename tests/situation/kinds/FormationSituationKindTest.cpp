#include "situation/kinds/FormationSituationKind.h"

#include <gtest/gtest.h>

#include "support/SituationReading.h"

namespace plumbline {
namespace {

struct FormationSituationKindTest : test::SituationReading {};

TEST_F(FormationSituationKindTest, aPlayersPlaceIsWhatItSaid) {
  const Situation s = read(
      "about: x\ndecides: formation\nmode: kickOffOwn\nball: [0, 0]\nplayer: 3\n"
      "team: [[1, -14, 0, 0, 14], [3, -6, 1, 0.5, 7]]\nexpected: {striker: 3, role: striker}\n");
  EXPECT_EQ(s.mode, TeamPlayMode::kickOffOwn);
  EXPECT_EQ(s.player, 3);
  EXPECT_EQ(s.robot.position, Vec2(-6, 1));
  ASSERT_EQ(s.team.size(), 2u);
  EXPECT_EQ(s.team[1].timeToBall, 7);
}

TEST_F(FormationSituationKindTest, thePlayerIsOneOfTheTeam) {
  EXPECT_EQ(errorOf("about: x\ndecides: formation\nball: [0, 0]\nplayer: 4\nteam: [[1, 0, 0, 0, 1]]\n"),
            "one.yaml:4: player must be one of the team's, not 4: its place is there");
}

TEST(FormationExpectedTest, wordsAreNumbersAndAnArea) {
  FormationExpected e;
  e.striker = 7;
  e.area = {-9, -1, -4, 4};
  EXPECT_EQ(e.words(3), "number 7 goes to the ball; number 3 is a supporter at x -9 to -1, y -4 to 4");
  e.striker = 3;
  e.role = FormationExpected::Role::striker;
  EXPECT_EQ(e.words(3), "number 3 goes to the ball");
}

}  // namespace
}  // namespace plumbline
