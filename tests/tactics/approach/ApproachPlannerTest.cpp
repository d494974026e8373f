#include "tactics/approach/ApproachPlanner.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

struct ApproachPlannerTest : testing::Test {
  ApproachPlannerTest() { p.path = {.avoidRadius = 0.26, .stepAngle = 0.25, .behindAngle = 0.53}; }
  WalkCommand plan(const WalkPoint& robot) { return planner.update(robot, ball, beyond, limits, p); }

  // Walks as planned, with the planned delay, until the robot rests at its place.
  double walk(WalkPoint robot) {
    std::vector<Vec3> asked(static_cast<std::size_t>(std::lround(p.delay / 0.02)), Vec3::Zero());
    closest = 1e9;
    for (double time = 0; time < 15; time += 0.02) {
      const WalkCommand command = plan(robot);
      asked.push_back({command.velocity.x(), command.velocity.y(), command.turn});
      robot = walked(robot, asked.front(), limits, 0.02);
      asked.erase(asked.begin());
      closest = std::min(closest, (robot.pose.position - ball).norm());
      if (robot.pose.position.norm() < 0.02 && std::abs(robot.pose.heading) < 0.1) return time;
    }
    return 15;
  }

  ApproachPlannerParameters p;
  WalkLimits limits{.forward = 0.6,
                    .backward = 0.45,
                    .sideways = 0.35,
                    .turn = 2.5,
                    .accelerationForward = 1.2,
                    .decelerationForward = 1,
                    .accelerationSideways = 0.5,
                    .accelerationTurn = 9};
  Vec2 ball{0.2, 0.05};
  double beyond = 0, closest = 0;
  ApproachPlanner planner;
};

TEST_F(ApproachPlannerTest, fromEveryPlaceAndHeadingTheRobotArrivesAndTheBallIsSpared) {
  double sum = 0;
  int count = 0;
  for (int place = 0; place < 360; place += 45)
    for (int heading = 0; heading < 360; heading += 60) {
      planner = {};
      const Vec2 at = ball + 1.5 * Vec2(std::cos(fromDegrees(place)), std::sin(fromDegrees(place)));
      const double time = walk({Pose2(at, normalizeAngle(fromDegrees(heading)))});
      EXPECT_LT(time, 8) << place << ", " << heading;
      EXPECT_GT(closest, 0.13) << place << ", " << heading;
      sum += time;
      ++count;
    }
  EXPECT_LT(sum / count, 5);
}

TEST_F(ApproachPlannerTest, whereTheLastHeadingIsTheOneNowAShortWayBackIsWalkedBackward) {
  const WalkCommand command = plan({Pose2(0.6, 0.4)});
  EXPECT_LT(command.velocity.x(), 0);
  EXPECT_NE(planner.facing(), Facing::forward);
}

TEST_F(ApproachPlannerTest, aLongWayIsWalkedForward) {
  plan({Pose2(-0.5, -1.9, 1.5)});
  EXPECT_EQ(planner.facing(), Facing::forward);
}

TEST_F(ApproachPlannerTest, theShorterSideAroundTheBallIsTaken) {
  plan({Pose2(1, 0.6, pi)});
  EXPECT_EQ(planner.side(), Around::counterclockwise);
  planner.leave();
  plan({Pose2(1, -0.6, pi)});
  EXPECT_EQ(planner.side(), Around::clockwise);
}

TEST_F(ApproachPlannerTest, anotherWayHasToBeClearlyFaster) {
  p.switchGain = 2;
  plan({Pose2(1, 0.06, pi)});
  const Around first = planner.side();
  for (int i = 0; i < 6; ++i) plan({Pose2(1, 0.04, pi)});
  for (int i = 0; i < 6; ++i) plan({Pose2(1, 0.06, pi)});
  EXPECT_EQ(planner.side(), first);
}

TEST_F(ApproachPlannerTest, brakesBeforeThePlaceUnlessItLiesBeyond) {
  const WalkPoint robot{Pose2(-0.1, 0), Vec3(0.5, 0, 0)};
  EXPECT_LT(plan(robot).velocity.x(), 0.3);
  beyond = 0.8;
  planner.leave();
  EXPECT_GT(plan(robot).velocity.x(), 0.5);
}

TEST_F(ApproachPlannerTest, theWayCanBeDrawn) {
  const WalkPoint robot{Pose2(1.2, 0.3, 2)};
  const auto drawn = [&] { return planner.way(robot, ball, beyond, limits, p); };
  EXPECT_TRUE(drawn().empty()) << "nothing is planned";
  plan(robot);
  EXPECT_TRUE(planner.plans());
  const std::vector<Pose2> way = drawn();
  ASSERT_GT(way.size(), 20U);
  EXPECT_NEAR(way.front().x(), 1.2, 1e-9);
  EXPECT_LT(way.back().position.norm(), 0.03);
  EXPECT_LT(std::abs(way.back().heading), 0.15);
  EXPECT_GT((way[1].position - way[0].position).norm() + std::abs(way[1].heading - way[0].heading), 0);
  planner.leave();
  EXPECT_TRUE(drawn().empty());
}

TEST_F(ApproachPlannerTest, theTimeIsTheOneThatTheWayTakes) {
  const WalkPoint robot{Pose2(-1.2, 0.3, 0.5)};
  plan(robot);
  const double planned = planner.seconds();
  planner = {};
  EXPECT_NEAR(walk(robot), planned + p.delay, 0.4);
}

}  // namespace
