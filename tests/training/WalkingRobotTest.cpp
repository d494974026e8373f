#include "training/WalkingRobot.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "simspark/LeagueRobots.h"
#include "training/ServoWalker.h"

namespace plumbline::training {
namespace {

/// Joint angles commanded in six seconds of a walk whose sensors tell this much noise.
std::vector<double> commanded(const walking::WalkGaits& gaits, const RobotModel& robot, double dt,
                              double noise) {
  walking::WalkEngine engine(gaits, robot);
  Random random(1);
  const auto some = [&] { return noise * random.uniform(-1, 1); };
  std::vector<double> all;
  for (int i = 0; i < std::lround(6 / dt); ++i) {
    walking::WalkSensors sensors;
    sensors.dt = dt;
    sensors.torsoAngles = Vec2(some(), some());
    sensors.gyro = 10 * Vec3(some(), some(), some());
    sensors.angles = engine.stand().angles;
    sensors.feet.emplace();
    for (auto& foot : sensors.feet->foot)
      foot = walking::FootContact{Vec3(some(), some(), 0), Vec3(0, 0, 25 + 100 * some())};
    const walking::WalkOutput output = engine.update({Vec2(0.1, 0), 0.1, true}, sensors);
    all.insert(all.end(), output.angles.begin(), output.angles.end());
  }
  return all;
}

TEST(WithoutFeedback, nothingMeasuredHasAnEffect) {
  const RobotModel nao = Humanoid(findMechanism("nao_v5")).model();
  const walking::WalkGaits gaits = readServoGaits("nao_v5");
  EXPECT_NE(commanded(gaits, nao, 0.01, 0), commanded(gaits, nao, 0.01, 0.05));
  const walking::WalkGaits open = withoutFeedback(gaits);
  EXPECT_EQ(commanded(open, nao, 0.01, 0), commanded(open, nao, 0.01, 0.05));
  for (const int type : {0, 4}) {
    const walking::WalkGaits league = withoutFeedback(readLeagueGaits(type));
    EXPECT_EQ(commanded(league, simsparkRobot(type), 0.02, 0),
              commanded(league, simsparkRobot(type), 0.02, 0.05));
  }
}

}  // namespace
}  // namespace plumbline::training
