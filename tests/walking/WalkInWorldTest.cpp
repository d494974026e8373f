#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "simspark/LeagueRobots.h"
#include "training/WalkingRobot.h"

namespace plumbline::walking {
using namespace training;
namespace {

/// What a type reached with the values in config/. It is the worst of six starts at other headings and after
/// other waits (sideways without single starts of types 2 and 4 that came to 0.55 and 0.47) [m/s, degrees/s].
struct Reached {
  double forward, backward, sideways, turn;
};
constexpr std::array<Reached, 5> reached{{{0.99, 0.82, 0.66, 124},
                                          {1.05, 0.85, 0.65, 129},
                                          {1.00, 0.73, 0.59, 120},
                                          {1.13, 0.80, 0.67, 125},
                                          {0.97, 0.75, 0.57, 128}}};

/// The robots walk in the simulator with the values in config/. A loss of an eighth shows here, a smaller one
/// in the benchmark (doc/results/walking.md). A type that is not in the table has to be as good as the
/// slowest.
class WalkInWorld : public testing::TestWithParam<int> {
protected:
  WalkingRobot robot{GetParam()};

  static double least(double Reached::*what) {
    constexpr double share = 0.875;
    if (static_cast<std::size_t>(GetParam()) < reached.size())
      return share * reached[static_cast<std::size_t>(GetParam())].*what;
    return share * std::ranges::min(reached, {}, what).*what;
  }
  static WalkRequest walk(double x, double y, double turn) { return {Vec2(x, y), turn, true}; }
  /// Mean velocity in the robot's own frame over the time.
  Vec2 speed(const WalkRequest& request, double seconds) {
    Vec2 way = Vec2::Zero();
    for (int i = 0; i < seconds / 0.02; ++i) {
      EXPECT_TRUE(robot.step(request)) << "fell after " << i << " cycles";
      if (HasFailure()) break;
      way += robot.moved.position;
    }
    return way / seconds;
  }
};

TEST_P(WalkInWorld, forward) {
  robot.run(walk(9, 0, 0), 2);
  EXPECT_GT(speed(walk(9, 0, 0), 4).x(), least(&Reached::forward));
}

TEST_P(WalkInWorld, sideways) {
  robot.run(walk(0, 9, 0), 2);
  EXPECT_GT(speed(walk(0, 9, 0), 3).y(), least(&Reached::sideways));
  robot.restart();
  robot.run(walk(0, -9, 0), 2);
  EXPECT_LT(speed(walk(0, -9, 0), 3).y(), -least(&Reached::sideways));
}

TEST_P(WalkInWorld, backward) {
  robot.run(walk(-9, 0, 0), 2);
  EXPECT_LT(speed(walk(-9, 0, 0), 3).x(), -least(&Reached::backward));
}

TEST_P(WalkInWorld, turns) {
  for (const double direction : {1.0, -1.0}) {
    robot.restart();
    ASSERT_TRUE(robot.run(walk(0, 0, 9 * direction), 1));
    const double before = robot.turned();
    ASSERT_TRUE(robot.run(walk(0, 0, 9 * direction), 2));
    EXPECT_GT(toDegrees(robot.turned() - before) * direction / 2, least(&Reached::turn));
  }
}

TEST_P(WalkInWorld, startsAndStopsAgainAndAgain) {
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(robot.run(walk(0.3, i % 2 == 0 ? 0.1 : -0.1, 0.3), 1.1));
    ASSERT_TRUE(robot.run({}, 2));
    EXPECT_TRUE(robot.output.standing);
  }
}

TEST_P(WalkInWorld, odometryFitsTheWay) {
  robot.run(walk(0.3, 0, 0), 1);
  Pose2 odometry, way;
  for (int i = 0; i < 200; ++i) {
    robot.step(walk(0.3, 0, 0));
    odometry = odometry * robot.output.odometry;
    way = way * robot.moved;
  }
  EXPECT_NEAR(odometry.x() / way.x(), 1, 0.06);
}

TEST_P(WalkInWorld, whatWasObservedTellsTheWayBetterThanWhatWasPlanned) {
  // Mean error over parts of a second of the way, for requests that change.
  const auto error = [&](double measured) {
    WalkGaits gaits = readLeagueGaits(GetParam());
    gaits.base.odometry.observedShare = measured;
    robot.use(gaits);
    double miss = 0, length = 0;
    for (const WalkRequest& request :
         {walk(0.4, 0, 0), walk(0, 0.2, 1), walk(-0.2, 0, 0), walk(0.3, -0.1, -1)})
      for (int part = 0; part < 3; ++part) {
        Pose2 odometry, way;
        for (int i = 0; i < 40; ++i) {
          robot.step(request);
          odometry = odometry * robot.output.odometry;
          way = way * robot.moved;
        }
        miss += (odometry.position - way.position).norm();
        length += way.position.norm();
      }
    return miss / length;
  };
  const double observed = error(1);
  EXPECT_LT(observed, 0.08);
  EXPECT_LT(observed, error(0));
}

TEST_P(WalkInWorld, knowsTheVelocityOfItsMass) {
  Vec2 squares = Vec2::Zero();
  int count = 0;
  for (const WalkRequest& request : {walk(9, 0, 0), walk(0, 0.2, 1), walk(-0.2, 0, 0)})
    for (int i = 0; i < 100; ++i) {
      const Vec2 truth = robot.comVelocity();
      robot.step(request);
      squares += (robot.engine.observed().velocity - truth).cwiseAbs2();
      ++count;
    }
  EXPECT_LT(std::sqrt(squares.x() / count), 0.03);
  EXPECT_LT(std::sqrt(squares.y() / count), 0.03);
}

TEST_P(WalkInWorld, walksThroughABall) {
  for (int i = 0; i < 3; ++i) {
    robot.restart();
    robot.local.world().setBall(Vec3(0.5, 0.05 * (i - 1), 0.042), Vec3::Zero());
    EXPECT_TRUE(robot.run(walk(9, 0, 0), 3));
  }
}

/// Steps on the spot or stands, is pushed from the front by 3.5 N s over 0.1 s; whether it stays upright.
bool survivesAPush(const WalkGaits& gaits, const WalkRequest& request) {
  WalkingRobot robot(0, gaits);
  double mass = 0;
  for (const Link& link : robot.model.links) mass += link.mass;
  if (!robot.run(request, 2)) return false;
  for (int i = 0; i < 5; ++i) {
    robot.push(Vec3(-3.5 / mass / 5, 0, 0));
    if (!robot.step(request)) return false;
  }
  return robot.run(request, 3);
}

TEST(WalkPushed, captureStepsSaveWhatFallsInOpenLoop) {
  const WalkGaits gaits = readLeagueGaits(0);
  const WalkRequest onTheSpot{Vec2::Zero(), 0, true};
  EXPECT_TRUE(survivesAPush(gaits, onTheSpot));
  EXPECT_FALSE(survivesAPush(withoutFeedback(gaits), onTheSpot));
}

TEST(WalkPushed, standingItStepsAndStandsAgain) {
  WalkingRobot robot(0);
  ASSERT_TRUE(robot.run({}, 1));
  bool stepped = false;
  double mass = 0;
  for (const Link& link : robot.model.links) mass += link.mass;
  for (int i = 0; i < 200; ++i) {
    if (i < 5) robot.push(Vec3(4.0 / mass / 5, 0, 0));
    ASSERT_TRUE(robot.step({})) << "fell after " << i << " cycles";
    stepped = stepped || robot.output.support != Support::both;
  }
  EXPECT_TRUE(stepped);
  EXPECT_TRUE(robot.output.standing);
}

INSTANTIATE_TEST_SUITE_P(SimSpark, WalkInWorld, testing::Range(0, numSimsparkTypes()));

}  // namespace
}  // namespace plumbline::walking
