#include "situation/kinds/StrikerSituationKind.h"

#include <gtest/gtest.h>

#include "support/SituationReading.h"

namespace plumbline {
namespace {

struct StrikerSituationKindTest : test::SituationReading {};

TEST_F(StrikerSituationKindTest, readsWhereMatesGoAndWhatTheRobotCanKick) {
  const Situation s = read(test::strikersFile);
  EXPECT_EQ(s.others.at(0).velocity, Vec2(0.5, 0));
  ASSERT_EQ(s.going.size(), 1u);
  EXPECT_EQ(s.going[0].number, 7);
  EXPECT_EQ(s.going[0].place.position, Vec2(-2, 4));
  EXPECT_EQ(s.going[0].heading, 1.5);
  const auto& kicks = knownTo<StrikerKnowledge>(s).kicks;
  ASSERT_EQ(kicks.size(), 1u);
  EXPECT_EQ(kicks[0].distance, 3.4);
  EXPECT_NEAR(kicks[0].scatter, pi / 2, 1e-12) << "degrees in the file";
  const auto* expected = expectedOf<StrikerExpected>(s);
  ASSERT_TRUE(expected);
  EXPECT_EQ(expected->action, StrikerExpected::Action::kick);
  EXPECT_EQ(expected->direction, Vec2(-0.7, 0.7));
  EXPECT_EQ(*expected->reach, Vec2(2, 4));
}

TEST_F(StrikerSituationKindTest, anErrorNamesFileLineAndKey) {
  EXPECT_EQ(errorWith("[[-2, 4, 1.5]]", "[[1, 1, 1], [2, 2, 2], [3, 3, 3]]"),
            "one.yaml:7: going must have one for each mate, 2 at most, not 3");
  EXPECT_EQ(errorWith("direction: [-0.7, 0.7]", "direction: [0.7, -0.7]"),
            "one.yaml:10: expected.direction must be [from, to] with the smaller one first, not [0.7, -0.7]");
}

TEST(StrikerExpectedTest, wordsAreDirections) {
  StrikerExpected e;
  e.direction = {-0.5, 0.35};
  EXPECT_EQ(e.words(0), "kicks or dribbles between 29 degrees right and 20 degrees left");
  e.action = StrikerExpected::Action::kick;
  e.direction = {0, 0.35};
  e.reach = Vec2(0, 4);
  EXPECT_EQ(e.words(0), "kicks between straight ahead and 20 degrees left, 0 to 4 m far");
}

}  // namespace
}  // namespace plumbline
