#include "situation/kinds/GoalieSituationKind.h"

#include <gtest/gtest.h>

#include "support/SituationReading.h"

namespace plumbline {
namespace {

struct GoalieSituationKindTest : test::SituationReading {};

TEST_F(GoalieSituationKindTest, hasNoKicks) {
  EXPECT_EQ(
      errorOf("about: x\ndecides: goalie\nrobot: [0, 0, 0]\nball: [0, 0]\nvelocity: [0, 0]\nkicks: []\n")
          .substr(0, 31),
      "one.yaml:6: unknown key \"kicks\"");
}

TEST(GoalieExpectedTest, wordsAreAPlace) {
  GoalieExpected e;
  e.place = {-14, 0.25};
  e.within = 0.3;
  e.fromTheWay = 0.05;
  EXPECT_EQ(e.words(0), "goes to (-14, 0.25) within 0.3 m, at most 0.05 m from the ball's way");
}

}  // namespace
}  // namespace plumbline
