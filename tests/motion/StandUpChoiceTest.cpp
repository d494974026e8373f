#include "motion/StandUpChoice.h"

#include <gtest/gtest.h>

namespace plumbline::motion {
namespace {

class StandUpChoiceTest : public testing::Test {
protected:
  StandUpChoiceTest() {
    parameters.fastFront = "jumpFront";
    parameters.fastBack = "jumpBack";
    KeyframeMotion front, back;
    front.name = "jumpFront";
    back.name = "jumpBack";
    choice.learn(parameters, {front, back});
  }
  std::string next(LyingOn how, bool again) { return choice.next(parameters, how, again); }

  StandUpParameters parameters;
  StandUpChoice choice;
};

TEST_F(StandUpChoiceTest, takesTheFastOneAndTheOtherOneInTurn) {
  EXPECT_EQ(next(LyingOn::front, false), "jumpFront");
  EXPECT_EQ(next(LyingOn::front, true), "standUpFront");
  EXPECT_EQ(next(LyingOn::back, true), "jumpBack");
  EXPECT_EQ(next(LyingOn::back, true), "standUpBack");
  EXPECT_EQ(next(LyingOn::back, false), "jumpBack") << "another fall";
}

TEST_F(StandUpChoiceTest, aRollIsNoTryThatFailed) {
  EXPECT_EQ(next(LyingOn::side, false), "rollOver");
  EXPECT_TRUE(choice.rolled());
  EXPECT_EQ(next(LyingOn::side, true), "rollOver") << "it did not roll far enough";
  EXPECT_EQ(next(LyingOn::back, true), "jumpBack");
  EXPECT_FALSE(choice.rolled());
  EXPECT_EQ(next(LyingOn::side, true), "rollOver") << "the try ended on the side";
  EXPECT_EQ(next(LyingOn::back, true), "standUpBack");
}

TEST_F(StandUpChoiceTest, whereARobotHasNoFastMotionTheSlowOneIsTheFirst) {
  choice.learn(parameters, {});
  EXPECT_EQ(next(LyingOn::front, false), "standUpFront");
  EXPECT_EQ(next(LyingOn::back, false), "standUpBack");
}

TEST_F(StandUpChoiceTest, forgetsItsTries) {
  next(LyingOn::back, false);
  next(LyingOn::back, true);
  choice.forget();
  EXPECT_EQ(next(LyingOn::back, true), "standUpBack") << "the try before failed";
  choice.forget();
  EXPECT_EQ(next(LyingOn::back, false), "jumpBack");
}

TEST(LyingOn, theSideThatIsDown) {
  EXPECT_EQ(lyingOn(Vec3(-1, 0, 0)), LyingOn::front);
  EXPECT_EQ(lyingOn(Vec3(1, 0, 0)), LyingOn::back);
  EXPECT_EQ(lyingOn(Vec3(0.6, -0.8, 0)), LyingOn::side);
  EXPECT_EQ(lyingOn(Vec3(0.6, 0.8, 0)), LyingOn::side);
}

TEST(StandsUpFrom, whereAMotionIsNamed) {
  StandUpParameters parameters;
  for (const LyingOn how : {LyingOn::front, LyingOn::back, LyingOn::side})
    EXPECT_TRUE(standsUpFrom(parameters, how));
  parameters.back = "";
  EXPECT_TRUE(standsUpFrom(parameters, LyingOn::front));
  EXPECT_FALSE(standsUpFrom(parameters, LyingOn::back));
  parameters.front = parameters.side = "";
  EXPECT_FALSE(standsUpFrom(parameters, LyingOn::front));
  EXPECT_FALSE(standsUpFrom(parameters, LyingOn::side));
  EXPECT_FALSE(missingStandUp(parameters, {})) << "it stays where it lies";
}

TEST(MissingStandUp, namesTheFirstMotionThatIsNotThere) {
  StandUpParameters parameters;
  std::vector<KeyframeMotion> motions;
  for (const char* name : {"standUpFront", "standUpBack", "rollOver", "standUpBackFast"}) {
    KeyframeMotion motion;
    motion.name = name;
    motions.push_back(motion);
  }
  EXPECT_FALSE(missingStandUp(parameters, motions)) << "no fast motion is asked for";
  parameters.fastBack = "standUpBackFast";
  EXPECT_FALSE(missingStandUp(parameters, motions));
  parameters.fastFront = "standUpBackFats";
  const auto missing = missingStandUp(parameters, motions);
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->parameter, "fastFront");
  EXPECT_EQ(missing->problem,
            "there is no motion standUpBackFats in motions/; did you mean \"standUpBackFast\"?");
  motions.erase(motions.begin());
  EXPECT_EQ(missingStandUp(parameters, motions)->parameter, "front");
}

}  // namespace
}  // namespace plumbline::motion
