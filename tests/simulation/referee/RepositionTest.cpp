#include "simulation/referee/Reposition.h"

#include "RefereeFixture.h"
#include "simulation/referee/RobotBox.h"

namespace plumbline::simulation {
namespace {

class Reposition : public test::RefereeTest {
protected:
  /// What the referee knows after a cycle of play far away from everything.
  Reposition() { ball(-8, 8); }
  void clear(double x, double y) {
    playOn();
    ball(x, y);
    referee().dropBall(game, world);
  }
};

TEST_F(Reposition, placesOffTheField) {
  EXPECT_EQ(outsidePlace({}, Vec3(0, 1, 0), left, 2), Vec3(-3, -10.5, 1));
  EXPECT_EQ(outsidePlace({}, Vec3(0, -1, 0), left, 7), Vec3(0, 10.5, 1));
  EXPECT_EQ(outsidePlace({}, Vec3(0, -1, 0), right, 11), Vec3(0.6 * -4, 10.5, 1));
}

TEST_F(Reposition, somebodyInTheWayMeansAPlaceNextToIt) {
  auto &mover = add(left, 2, 0.5, 0), &there = add(left, 3, -2.5, 0);
  clear(0, 0);
  EXPECT_EQ(moves(there), 0);
  const Vec3 found = place(mover);
  EXPECT_GT((found - place(there)).norm(), 0.5);
  EXPECT_LT((found - Vec3(-2.5, 0, standing)).norm(), 1) << "but near to where it belongs";
}

TEST_F(Reposition, theFirstPlaceIsTakenIfThatIsWanted) {
  rules.moves.attempts = 0;
  auto& mover = add(left, 2, 0.5, 0);
  add(left, 3, -2.5, 0);
  clear(0, 0);
  EXPECT_LT((place(mover) - Vec3(-2.5, 0, standing)).norm(), 1e-9);
}

TEST_F(Reposition, nobodyIsPutBehindTheGoalLine) {
  auto& mover = add(left, 2, -13.5, 4);
  clear(-13.9, 4);
  EXPECT_LT((place(mover) - Vec3(-13.5, 1.5, standing)).norm(), 1e-9) << "inwards instead";
}

TEST_F(Reposition, notIntoTheFullPenaltyArea) {
  add(left, 1, -14.5, 0), add(left, 2, -14, 1.5), add(left, 3, -14, -1.5);
  auto& mover = add(left, 4, -11, 0);
  clear(-11.2, 0);  // 2.5 m back is -13.7
  EXPECT_GT(moves(mover), 0);
  EXPECT_GT(std::fabs(place(mover).y()), 3) << "there are three already";
}

TEST_F(Reposition, boxOfAStandingRobot) {
  const Man& man = add(left, 2, 1, 2);
  Participant player(Member{1, left, 2, man.robot, &model, nullptr});
  const RobotBox box = robotBox(world, player);
  EXPECT_NEAR(box.low.x(), 1 - 0.2, 1e-9) << "behind";
  EXPECT_NEAR(box.high.y(), 2 + 0.28, 1e-9) << "at the side";
  EXPECT_GT(box.high.x(), 1.18) << "the arms in front";
  EXPECT_NEAR(box.low.z(), 0, 0.001);
  EXPECT_NEAR(box.high.z(), standing + 0.09 + 0.065 + 0.005 + 0.065, 0.01);
  const Area area = robotArea(world, player);
  EXPECT_NEAR(area.high.y(), 2.108, 1e-6) << "middles of the upper arms";
  EXPECT_LT(area.high.x() - area.low.x(), 0.2);
}

}  // namespace
}  // namespace plumbline::simulation
