#include "situation/ExpectedFile.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(ExpectedWords, ofAStrikerAreDirections) {
  Expected expected;
  StrikerExpected& e = expected.emplace<StrikerExpected>();
  e.direction = {-0.5, 0.35};
  EXPECT_EQ(expectedWords(expected, 0), "kicks or dribbles between 29 degrees right and 20 degrees left");
  e.action = StrikerExpected::Action::kick;
  e.direction = {0, 0.35};
  e.reach = Vec2(0, 4);
  EXPECT_EQ(expectedWords(expected, 0), "kicks between straight ahead and 20 degrees left, 0 to 4 m far");
}

TEST(ExpectedWords, ofOthersArePlacesAndNumbers) {
  EXPECT_EQ(expectedWords(GoalieExpected{{-14, 0.25}, 0.3, 0.05}, 0),
            "goes to (-14, 0.25) within 0.3 m, at most 0.05 m from the ball's way");
  EXPECT_EQ(expectedWords(FormationExpected{7, FormationExpected::Role::supporter, {{-9, -1, -4, 4}}}, 3),
            "number 7 goes to the ball; number 3 is a supporter at x -9 to -1, y -4 to 4");
  EXPECT_EQ(expectedWords(FormationExpected{3, FormationExpected::Role::striker, {}}, 3),
            "number 3 goes to the ball");
  EXPECT_EQ(expectedWords(SkillExpected{"kick", Vec2(1, 2), {}, 0.3}, 0), "kicks to (1, 2) within 0.3 m");
  EXPECT_EQ(expectedWords(SkillExpected{"stand", {}, {}, 0}, 0), "stands");
  EXPECT_EQ(expectedWords(BlockExpected{9, {-9.9, -0.2}, 0.5}, 0),
            "number 9 is blocked from (-9.9, -0.2) within 0.5 m");
  EXPECT_EQ(expectedWords(BlockExpected{}, 0), "nobody is blocked");
  EXPECT_EQ(expectedWords(CallExpected{true}, 0), "asks for pass mode");
  EXPECT_EQ(expectedWords({}, 0), "");
}

}  // namespace
}  // namespace plumbline
