#include "modules/behavior/SetPieceTaker.h"

#include <gtest/gtest.h>

#include "situation/kinds/SkillExpected.h"
#include "support/DrawnBy.h"
#include "support/ModuleHarness.h"
#include "support/Robots.h"
#include "support/SituationHarness.h"

using namespace plumbline;

namespace {

/// The striker of a team of eleven, with the project's own set pieces.
struct SetPieceTakerTest : testing::Test {
  SetPieceTakerTest() {
    harness.input<RobotPose>().valid = true;
    harness.input<BallPos>().valid = true;
    harness.input<FieldDimensions>();
    harness.input<OtherRobots>();
    harness.input<GameState>().playMode = TeamPlayMode::kickInOwn;
    harness.input<PlayerRole>().role = PlayerRole::striker;
    harness.input<PlayerRole>().members = 11;
    harness.input<BallPos>().field = {0, 10};
    harness.input<BallPos>().age = 0;
  }
  void add(bool mate, const Vec2& place) { test::addRobot(harness.input<OtherRobots>().robots, mate, place); }
  const SetPieceOutput& output() {
    harness.cycle();
    return harness.output<SetPieceOutput>();
  }
  test::ModuleHarness<SetPieceTaker> harness;
};

TEST_F(SetPieceTakerTest, kicksWhereTheMateIs) {
  add(true, {1.5, 5.5});
  EXPECT_TRUE(output().active);
  EXPECT_EQ(output().skill, Skill::kick);
  EXPECT_EQ(output().target.position, Vec2(1.5, 5.5));
  EXPECT_GT(output().tolerance, 0.05) << "it need not be exact";
}

TEST_F(SetPieceTakerTest, theKickOffGoesBackToAMate) {
  harness.input<GameState>().playMode = TeamPlayMode::kickOffOwn;
  harness.input<BallPos>().field = {0, 0};
  EXPECT_EQ(output().skill, Skill::kick);
  EXPECT_LT(output().target.position.x(), 0);
}

TEST_F(SetPieceTakerTest, kicksAroundAnOpponent) {
  add(true, {1.5, 5.5});
  add(true, {5.5, 9.0});
  add(false, {0.8, 7.5});
  EXPECT_EQ(output().target.position, Vec2(5.5, 9.0));
}

TEST_F(SetPieceTakerTest, keepsItsKickWhileNoOtherIsClearlyBetter) {
  add(true, {1.5, 5.5});
  const Vec2 first = output().target.position;
  harness.input<OtherRobots>().robots[0].position = {3.1, 6.3};  // half-way to the next kick's end
  EXPECT_EQ(output().target.position, first);
}

TEST_F(SetPieceTakerTest, waitsBetweenBallAndOwnGoalAtTheirRestart) {
  harness.input<GameState>().playMode = TeamPlayMode::freeKickOpponent;
  harness.input<BallPos>().field = {-5, 0};
  EXPECT_EQ(output().skill, Skill::moveToPos);
  EXPECT_TRUE(output().target.position.isApprox(Vec2(-7.2, 0)));
  EXPECT_NEAR(output().target.heading, 0, 1e-9) << "it faces the ball";
}

TEST_F(SetPieceTakerTest, isNothingForOthersInPlayOrAlone) {
  harness.input<PlayerRole>().role = PlayerRole::supporter;
  EXPECT_FALSE(output().active);
  harness.input<PlayerRole>().role = PlayerRole::striker;
  harness.input<PlayerRole>().mayTouchBall = false;
  EXPECT_FALSE(output().active);
  harness.input<PlayerRole>().mayTouchBall = true;
  harness.input<PlayerRole>().members = 1;
  EXPECT_FALSE(output().active);
  harness.input<PlayerRole>().members = 11;
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_FALSE(output().active);
  harness.input<GameState>().playMode = TeamPlayMode::kickInOwn;
  harness.input<BallPos>().age = 10;
  EXPECT_FALSE(output().active) << "a lost ball is searched by the striker";
}

TEST_F(SetPieceTakerTest, theTakerItsPieceAndTheChoiceAreDrawn) {
  add(true, {1.5, 5.5});
  harness.input<RobotPose>().pose = Pose2(-1, 9, 0);
  const Drawing drawing = test::drawnBy("draw:team:setPiece", [&] { output(); });
  EXPECT_EQ(test::placeOf(drawing, "kickInOwn"), Vec3(-1, 9, 0)) << "the taker's place";
  EXPECT_GT(test::countOf<shapes::Point>(drawing), 1u) << "what may be chosen";
  bool kick = false;
  for (const shapes::Shape& shape : drawing.shapes())
    if (const auto* line = std::get_if<shapes::Line>(&shape.form))
      kick = kick || (line->begin == Vec3(0, 10, 0) && line->end == Vec3(1.5, 5.5, 0));
  EXPECT_TRUE(kick);
}

TEST_F(SetPieceTakerTest, wherePlayersWaitIsDrawnAndNothingInPlay) {
  harness.input<GameState>().playMode = TeamPlayMode::kickInOpponent;
  const Vec2 place = output().target.position;
  const Drawing waits = test::drawnBy("draw:team:setPiece", [&] { output(); });
  ASSERT_EQ(test::countOf<shapes::Circle>(waits), 2u) << "the player and its place";
  EXPECT_EQ(std::get<shapes::Circle>(waits.shapes().back().form).centre, place);
  harness.input<GameState>().playMode = TeamPlayMode::playOn;
  EXPECT_TRUE(test::drawnBy("draw:team:setPiece", [&] { output(); }).shapes().empty());
}

TEST_F(SetPieceTakerTest, noiseOfABallInTheMiddleDoesNotMirrorThePiece) {
  harness.input<GameState>().playMode = TeamPlayMode::kickOffOwn;
  std::vector<Vec2> targets;
  for (const double y : {0.02, -0.03, 0.01, -0.3, 0.2}) {
    harness.input<BallPos>().field = {0, y};
    targets.push_back(output().target.position);
  }
  for (const Vec2& target : targets) EXPECT_EQ(target, targets.front());
}

TEST_F(SetPieceTakerTest, aBallClearlyOnTheOtherSideMirrorsIt) {
  harness.input<GameState>().playMode = TeamPlayMode::cornerOwn;
  harness.input<BallPos>().field = {14.9, 5.4};
  const Vec2 left = output().target.position;
  harness.input<BallPos>().field = {14.9, -5.4};
  EXPECT_EQ(output().target.position, Vec2(left.x(), -left.y()));
}

/// A file with positions and where people expect the ball or the player to go
/// (tests/data/situations/setPiece).
struct SetPieceSituations : SetPieceTakerTest, testing::WithParamInterface<std::string> {};

TEST_P(SetPieceSituations, areDecidedAsExpected) {
  const test::WrittenSituation<SkillExpected> written("setPiece", GetParam());
  test::placeScene(harness, *written);
  const SetPieceOutput& taken = output();
  ASSERT_TRUE(taken.active);
  const SkillExpected& expected = written.expected();
  EXPECT_EQ(taken.skill, expected.skill);
  EXPECT_LT((taken.target.position - *expected.target).norm(), expected.within)
      << "to " << taken.target.position.transpose();
}

INSTANTIATE_TEST_SUITE_P(Written, SetPieceSituations, testing::ValuesIn(test::situationNames("setPiece")),
                         test::situationName);

}  // namespace
