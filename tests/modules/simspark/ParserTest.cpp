#include "modules/simspark/Parser.h"

#include <gtest/gtest.h>

#include "framework/Controller.h"
#include "math/Angle.h"
#include "support/PerceptionModules.h"

namespace plumbline {
namespace {

using test::MessageSource;

class ParserTest : public testing::Test {
protected:
  ParserTest() : controller(ControllerOptions{}, test::perceptionModules()) {
    options->team = "Home";
    options->number = 5;
    options->type = 2;
    controller.objects().set(options);
    controller.objects().set(source);
  }
  void receive(const std::string& text) {
    source->text = text;
    controller.runCycles(1);
  }
  template <typename R>
  const R& get() const {
    return *controller.find<R>();
  }

  std::shared_ptr<AgentOptions> options = std::make_shared<AgentOptions>();
  std::shared_ptr<MessageSource> source = std::make_shared<MessageSource>();
  Controller controller;
};

const std::string first =
    "(time (now 8.02))(GS (unum 7) (team right) (sl 1) (sr 2) (t 3.50) (pm KickOff_Left))"
    "(GYR (n torso) (rt -2.00 0.00 1.00))(ACC (n torso) (a 0.00 1.00 9.81))(HJ (n hj1) (ax 10.00))"
    "(HJ (n hj2) (ax -20.00))";
const std::string second =
    "(time (now 8.04))(GS (sl 1) (sr 2) (t 3.52) (pm PlayOn))(hear Away 3.50 -30.00 hello)"
    "(GYR (n torso) (rt 0.00 0.00 0.00))(ACC (n torso) (a 0.00 0.00 9.81))(HJ (n hj1) (ax 11.00))"
    "(See (G1L (pol 5.00 10.00 1.00)) (B (pol 2.00 0.00 -10.00)) (P (team Away) (id 3) (head (pol 4.00 5.00 "
    "0.00)))"
    " (L (pol 3.00 1.00 -8.00) (pol 4.00 2.00 -7.00)))(FRP (n lf) (c 0.00 0.01 -0.01) (f 0.00 0.00 22.00))";

TEST_F(ParserTest, takesTheMessageApart) {
  receive(first);
  EXPECT_DOUBLE_EQ(get<FrameInfo>().time, 8.02);
  EXPECT_DOUBLE_EQ(get<FrameInfo>().cycleSeconds, 0.02) << "nominal in the first cycle";
  EXPECT_EQ(get<FrameInfo>().cycle, 1u);
  EXPECT_FALSE(get<FrameInfo>().restarted);
  EXPECT_EQ(get<PlayerInfo>().team, "Home");
  EXPECT_EQ(get<PlayerInfo>().number, 7) << "the server's word counts";
  EXPECT_EQ(get<PlayerInfo>().robot, "simspark_type2");
  EXPECT_TRUE(get<PlayerInfo>().sideKnown);
  EXPECT_FALSE(get<PlayerInfo>().leftSide);
  EXPECT_EQ(get<GameState>().playMode, TeamPlayMode::kickOffOpponent);
  EXPECT_EQ(get<GameState>().ownScore, 2);
  EXPECT_EQ(get<GameState>().opponentScore, 1);
  EXPECT_DOUBLE_EQ(get<GameState>().time, 3.5);
  EXPECT_LT((get<SensorData>().gyro - Vec3(0, fromDegrees(2), fromDegrees(1))).norm(), 1e-12);
  EXPECT_EQ(get<SensorData>().acc, Vec3(1, 0, 9.81));
  EXPECT_NEAR(get<JointData>().angles[headPitch], fromDegrees(20), 1e-12);
  EXPECT_FALSE(get<VisionInfo>().newImage);

  receive(second);
  EXPECT_NEAR(get<FrameInfo>().cycleSeconds, 0.02, 1e-9);
  EXPECT_TRUE(get<PlayerInfo>().sideKnown) << "sent once";
  EXPECT_EQ(get<PlayerInfo>().number, 7);
  EXPECT_EQ(get<GameState>().playMode, TeamPlayMode::playOn);
  EXPECT_TRUE(get<VisionInfo>().newImage);
  EXPECT_TRUE(get<PolarBallPercept>().seen);
  EXPECT_DOUBLE_EQ(get<PolarBallPercept>().position.distance, 2);
  ASSERT_EQ(get<PolarLandmarkPercept>().landmarks.size(), 1u) << "the ball is none";
  EXPECT_EQ(get<PolarLandmarkPercept>().landmarks[0].name, "G1L");
  EXPECT_NEAR(get<PolarLandmarkPercept>().landmarks[0].position.azimuth, fromDegrees(10), 1e-12);
  ASSERT_EQ(get<PolarLinePercept>().lines.size(), 1u);
  EXPECT_NEAR(get<PolarLinePercept>().lines[0].b.elevation, fromDegrees(-7), 1e-12);
  ASSERT_EQ(get<PolarPlayerPercept>().players.size(), 1u);
  EXPECT_EQ(get<PolarPlayerPercept>().players[0].parts[0].name, "head");
  ASSERT_EQ(get<HearPercept>().messages.size(), 1u);
  EXPECT_EQ(get<HearPercept>().messages[0].text, "hello");
  EXPECT_TRUE(get<SensorData>().leftFoot.contact);
  EXPECT_FALSE(get<SensorData>().rightFoot.contact);
  EXPECT_NEAR(get<JointData>().angles[headPitch], fromDegrees(20), 1e-12) << "not sent: as before";
}

TEST_F(ParserTest, aBrokenMessageChangesNothing) {
  receive(first);
  receive(second);
  for (const std::string& broken :
       {std::string(), second.substr(0, second.size() / 2), std::string("garbage)))((("),
        std::string("(time (now x))"), std::string(1000, '(')}) {
    receive(broken);
    EXPECT_DOUBLE_EQ(get<FrameInfo>().time, 8.04);
    EXPECT_FALSE(get<FrameInfo>().restarted);
    EXPECT_FALSE(get<VisionInfo>().newImage) << "no image twice";
    EXPECT_TRUE(get<PolarLinePercept>().lines.empty());
    EXPECT_TRUE(get<HearPercept>().messages.empty());
    EXPECT_NEAR(get<JointData>().angles[headYaw], fromDegrees(11), 1e-12);
    EXPECT_EQ(get<SensorData>().acc, Vec3(0, 0, 9.81));
    EXPECT_EQ(get<GameState>().playMode, TeamPlayMode::playOn);
    EXPECT_EQ(get<PlayerInfo>().number, 7);
  }
  EXPECT_EQ(get<FrameInfo>().cycle, 7u);
}

TEST_F(ParserTest, timeGoingBackIsARestart) {
  receive(first);
  receive(second);
  receive("(time (now 0.04))(GS (unum 7) (team left) (sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))");
  EXPECT_TRUE(get<FrameInfo>().restarted);
  EXPECT_DOUBLE_EQ(get<FrameInfo>().cycleSeconds, 0.02);
  EXPECT_TRUE(get<PlayerInfo>().leftSide);
  receive("(time (now 0.06))(GS (sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))");
  EXPECT_FALSE(get<FrameInfo>().restarted);
}

TEST_F(ParserTest, groundTruthIsInTheTeamsFrame) {
  receive(
      "(time (now 1.00))(GS (unum 7) (team right) (sl 0) (sr 0) (t 0.00) (pm PlayOn))"
      "(GT (mypos (pose 3.00 -2.00 0.00) (up 0.00 0.00 1.00) (z 0.40) (forward 1.00 0.00 0.00))"
      " (B (1.00 0.50 0.04)))");
  const GroundTruth& truth = get<GroundTruth>();
  ASSERT_TRUE(truth.valid);
  EXPECT_LT((truth.T_field_torso.translation() - Vec3(-3, 2, 0.4)).norm(), 1e-9);
  EXPECT_NEAR(truth.T_field_torso.linear()(0, 0), -1, 1e-9);
  EXPECT_LT((truth.ball - Vec3(-1, -0.5, 0.04)).norm(), 1e-9);
}

TEST(PlayModeOf, bothSides) {
  EXPECT_EQ(playModeOf("BeforeKickOff", false), TeamPlayMode::beforeKickOff);
  EXPECT_EQ(playModeOf("Goal_Right", false), TeamPlayMode::goalOwn);
  EXPECT_EQ(playModeOf("Goal_Right", true), TeamPlayMode::goalOpponent);
  EXPECT_EQ(playModeOf("direct_free_kick_left", true), TeamPlayMode::directFreeKickOwn);
  EXPECT_EQ(playModeOf("pass_left", false), TeamPlayMode::passOpponent);
  EXPECT_EQ(playModeOf("", true), TeamPlayMode::unknown);
}

}  // namespace
}  // namespace plumbline
