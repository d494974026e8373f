// The modules of config/modules/ drive a robot that is none of the league's.
#include "ServoPlatform.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/Controller.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/TorsoPose.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline::test {
namespace {

class ServoAgent : public testing::Test {
protected:
  ServoAgent() {
    ControllerOptions setup;
    setup.modulesConfig = "tests/modules/platform/config/platforms/servo/modules.cfg";
    setup.configDirectories = {"config", platform->configFolders("config").front()};
    controller = std::make_unique<Controller>(setup);
    platform->addObjects(controller->objects(), [](const std::string&) {});
  }
  ServoWorld& world() { return *controller->objects().find<ServoWorld>(); }
  void run(double seconds) { controller->runCycles(static_cast<int>(seconds * world().mechanism.controlHz)); }
  Vec3 place() { return world().robot->base().pose.translation(); }
  Posture posture() { return controller->find<FallState>()->posture; }

  const std::unique_ptr<Platform> platform = Platforms::make("servo");
  std::unique_ptr<Controller> controller;
};

TEST_F(ServoAgent, standsOnLoadedServosAsHighAsItsWalkStands) {
  world().wish.motion = Motion::stand;
  run(3);
  EXPECT_EQ(posture(), Posture::upright);
  const Vec3 start = place();
  run(2);
  EXPECT_LT((place() - start).norm(), 0.003) << "it stands still";
  EXPECT_NEAR(place().z(), controller->find<TorsoPose>()->T_ground_torso.translation().z(), 0.01);
}

TEST_F(ServoAgent, walksAsFastAsAskedAndStops) {
  world().wish.motion = Motion::stand;
  run(2);
  const Vec3 start = place();
  world().wish.motion = Motion::walk;
  world().wish.walkVelocity = Vec2(0.2, 0);
  run(10);
  EXPECT_EQ(controller->find<MotionSelection>()->motion, Motion::walk);
  EXPECT_EQ(posture(), Posture::upright);
  const Vec2 gone = (place() - start).head<2>();
  EXPECT_NEAR(gone.norm(), 1.9, 0.2);
  EXPECT_LT(std::abs(gone.y()), 0.4) << "straight on";
  world().wish.motion = Motion::stand;
  run(2);
  EXPECT_EQ(controller->find<MotionSelection>()->motion, Motion::stand);
  const Vec3 end = place();
  run(1);
  EXPECT_LT((place() - end).norm(), 0.01) << "it stands still";
}

TEST_F(ServoAgent, turns) {
  world().wish.motion = Motion::walk;
  world().wish.walkTurn = 0.5;
  const auto heading = [&] {
    const Vec3 forward = world().robot->base().pose.linear().col(0);
    return std::atan2(forward.y(), forward.x());
  };
  run(1);
  const double start = heading();
  run(4);
  EXPECT_EQ(posture(), Posture::upright);
  EXPECT_NEAR(heading() - start, 2, 0.4);
}

TEST_F(ServoAgent, aFallIsNoticedAndItStaysDownWithoutAMotionToStandUp) {
  world().wish.motion = Motion::stand;
  run(2);
  world().robot->push(Vec3(150, 0, 0), 0.3, 0);
  run(4);
  EXPECT_EQ(posture(), Posture::onFront);
  EXPECT_EQ(controller->find<MotionSelection>()->motion, Motion::stand);
}

TEST_F(ServoAgent, playsItsOwnMotions) {
  world().wish.motion = Motion::stand;
  run(2);
  world().wish.motion = Motion::specialAction;
  world().wish.specialAction = "wave";
  run(0.75);
  EXPECT_NEAR(world().robot->encoder(world().robot->joint("LElbowRoll")), -1.05, 0.1);
  EXPECT_LT(world().robot->encoder(world().robot->joint("LShoulderPitch")), -1.2);
  EXPECT_EQ(posture(), Posture::upright);
}

}  // namespace
}  // namespace plumbline::test
