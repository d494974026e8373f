#include "modules/simspark/SimSparkSend.h"

#include <gtest/gtest.h>

#include <memory>

#include "modules/simspark/FakeServer.h"
#include "simspark/LeagueRobots.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

/// A server that reads what is sent.
struct SimSparkSendTest : testing::Test {
  void SetUp() override {
    ASSERT_EQ(link->connection.connect("127.0.0.1", server.port()), "");
    server.accept();
    harness.objects().set(link);
  }
  test::FakeServer server;
  std::shared_ptr<SimSparkLink> link = std::make_shared<SimSparkLink>();
  test::ModuleHarness<SimSparkSend> harness;
};

TEST_F(SimSparkSendTest, sendsSpeedsOfTheJointsThatTheRobotHasAndTheBeam) {
  harness.input<SimSparkInfo>();
  harness.input<RobotDescription>().model = simsparkRobot(0);
  JointRequestWithSpeeds& request = harness.input<JointRequestWithSpeeds>();
  request.speeds[headYaw] = 0.5;
  request.speeds[lKneePitch] = 1.25;
  harness.input<BeamRequest>();
  harness.cycle();
  const std::string plain = server.receive();
  EXPECT_NE(plain.find("(he1 0.5"), std::string::npos) << plain;
  EXPECT_NE(plain.find("(lle4 -1.25"), std::string::npos) << plain;
  EXPECT_EQ(plain.find("lle7"), std::string::npos) << plain;
  EXPECT_EQ(plain.find("(beam"), std::string::npos) << plain;
  EXPECT_TRUE(plain.ends_with("(syn)")) << plain;

  harness.input<BeamRequest>().active = true;
  harness.input<BeamRequest>().pose = Pose2(-0.5, 1, fromDegrees(90));
  harness.cycle();
  const std::string beam = server.receive();
  EXPECT_NE(beam.find("(beam -0.50000 1.00000 90.00000)"), std::string::npos) << beam;
}

TEST_F(SimSparkSendTest, saysWordsAndCallsForAPass) {
  SayMessage& say = harness.input<SayMessage>();
  PassRequest& pass = harness.input<PassRequest>();
  harness.cycle();
  EXPECT_EQ(server.receive(), "(syn)") << "nothing to say";
  say.text = "hello";
  pass.active = true;
  harness.cycle();
  EXPECT_EQ(server.receive(), "(say hello)(pass)(syn)");
  say.text.clear();
  pass.active = false;
  harness.cycle();
  EXPECT_EQ(server.receive(), "(syn)") << "it is said once";
}

TEST(SimSparkSend, withoutAConnectionNothingIsSent) {
  auto link = std::make_shared<SimSparkLink>();
  test::ModuleHarness<SimSparkSend> harness;
  harness.objects().set(link);
  harness.cycle(2);
  EXPECT_FALSE(link->connection.connected());
}

}  // namespace
