// A server that has run for 10,000 days: its clock is 8.64e8 s, and more cycles have gone by than 32 bits
// count.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "framework/Controller.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/RobotPose.h"
#include "support/InProcessServer.h"
#include "support/PerceptionModules.h"

namespace plumbline {
namespace {

constexpr double tenThousandDays = 8.64e8;  // [s]

/// The message with its clock so much later.
std::string later(std::string text, double seconds) {
  const std::string name = "(now ";
  const std::size_t begin = text.find(name) + name.size(), end = text.find(')', begin);
  char number[40];
  std::snprintf(number, sizeof number, "%.2f", std::stod(text.substr(begin, end - begin)) + seconds);
  return text.replace(begin, end - begin, number);
}

/// Where the robot believes to be after ten seconds, with the clock so far on.
RobotPose believed(double since) {
  test::InProcessServer server{test::InProcessServer::Setup{}};
  const auto source = std::make_shared<test::MessageSource>();
  Controller controller(ControllerOptions{}, test::perceptionModules());
  controller.objects().set(std::make_shared<AgentOptions>());
  controller.objects().set(source);
  double before = 0;
  for (int i = 0; i < 250; ++i) {
    source->text = later(server.message(), since);
    controller.runCycles(1);
    const double time = controller.find<FrameInfo>()->time;
    if (i > 0) {
      EXPECT_NEAR(time - before, 0.02, 1e-6) << "message " << i;
    }
    before = time;
    server.walk(Vec2(0.2, 0), 0);
  }
  const RobotPose pose = *controller.find<RobotPose>();
  EXPECT_TRUE(pose.valid);
  EXPECT_LT((pose.pose.position - server.torso().translation().head<2>()).norm(), 0.3);
  return pose;
}

TEST(LongClock, anAgentSeesAfterTenThousandDaysAsOnTheFirst) {
  const RobotPose first = believed(0), last = believed(tenThousandDays);
  EXPECT_LT((first.pose.position - last.pose.position).norm(), 0.05);
}

}  // namespace
}  // namespace plumbline
