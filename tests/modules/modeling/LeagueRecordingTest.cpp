// What perception makes of messages recorded from the league's own server.
#include <gtest/gtest.h>

#include "framework/Controller.h"
#include "math/Angle.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/modeling/TorsoPose.h"
#include "support/PerceptionModules.h"
#include "support/Samples.h"

namespace plumbline {
namespace {

using namespace test;

class Recording {
public:
  Recording(const std::string& name, int type)
      : lines_(samples(name)), controller_(ControllerOptions{}, perceptionModules()) {
    auto options = std::make_shared<AgentOptions>();
    options->type = type;
    controller_.objects().set(options);
    controller_.objects().set(source_);
  }
  /// Up to this message, counted from 1.
  void playTo(std::size_t message) {
    for (; played_ < message; ++played_) {
      source_->text = lines_.at(played_);
      controller_.runCycles(1);
    }
  }
  std::size_t size() const { return lines_.size(); }
  template <typename R>
  const R& get() const {
    return *controller_.find<R>();
  }

private:
  std::vector<std::string> lines_;
  std::size_t played_ = 0;
  std::shared_ptr<MessageSource> source_ = std::make_shared<MessageSource>();
  Controller controller_;
};

TEST(LeagueRecording, hangsWhereTheServerPutsItAndIsBeamed) {
  Recording recording("agent_game_22_players", 4);
  recording.playTo(1);  // a new robot hangs at (0, -1) and looks at the left side line
  EXPECT_NEAR(recording.get<RobotPose>().pose.x(), 0, 0.02);
  EXPECT_NEAR(recording.get<RobotPose>().pose.y(), -1, 0.02);
  EXPECT_NEAR(toDegrees(recording.get<RobotPose>().pose.heading), 90, 0.2);
  EXPECT_LT(recording.get<BallPos>().field.norm(), 0.02);
  EXPECT_FALSE(recording.get<RobotPose>().valid) << "the side is not known yet";
  recording.playTo(7);
  EXPECT_TRUE(recording.get<PlayerInfo>().sideKnown);
  EXPECT_FALSE(recording.get<PlayerInfo>().leftSide);
  recording.playTo(40);
  const Pose2 beamed = recording.get<RobotPose>().pose;
  EXPECT_LT(beamed.x(), 0) << "in its own half, seen from the right team";
  // It stands until the kick-off; a minute later it would be elsewhere.
  double farthest = 0, turned = 0;
  for (std::size_t i = 41; i <= 480; ++i) {
    recording.playTo(i);
    const RobotPose& pose = recording.get<RobotPose>();
    ASSERT_TRUE(pose.valid) << "message " << i;
    farthest = std::max(farthest, (pose.pose.position - beamed.position).norm());
    turned = std::max(turned, std::abs(toDegrees(normalizeAngle(pose.pose.heading - beamed.heading))));
  }
  EXPECT_LT(farthest, 0.02);
  EXPECT_LT(turned, 0.3);
}

TEST(LeagueRecording, everyTypeIsBeamedStandsAndFallsOnItsBack) {
  for (int type = 0; type < 5; ++type) {
    Recording recording("agent_type" + std::to_string(type), type);
    recording.playTo(60);
    EXPECT_NEAR(recording.get<RobotPose>().pose.x(), -3, 0.06) << "beamed to (-3, 1) with the server's noise";
    EXPECT_NEAR(recording.get<RobotPose>().pose.y(), 1, 0.06);
    EXPECT_LT(recording.get<BallPos>().field.norm(), 0.02) << "the ball lies in the centre";
    EXPECT_EQ(recording.get<FallState>().posture, Posture::upright);
    recording.playTo(recording.size());
    EXPECT_EQ(recording.get<FallState>().posture, Posture::onBack) << "type " << type;
    EXPECT_EQ(recording.get<FallState>().falls, 1);
    EXPECT_NEAR(toDegrees(std::acos(recording.get<UprightVec>().up.x())), 0, 6) << "up is ahead";
    EXPECT_LT(recording.get<TorsoPose>().T_ground_torso.translation().z(), 0.08);
  }
}

TEST(LeagueRecording, theFirstImageAfterABeamIsEnough) {
  Recording recording("agent_realtime_type0", 0);
  recording.playTo(3);
  EXPECT_NEAR(recording.get<RobotPose>().pose.x(), -14.2, 0.05);
  recording.playTo(6);
  EXPECT_NEAR(recording.get<RobotPose>().pose.x(), -3, 0.06);
  EXPECT_NEAR(recording.get<RobotPose>().pose.y(), 1, 0.06);
}

}  // namespace
}  // namespace plumbline
