// Numbers that no sensor measures, in single messages to the whole agent: it plays on as if they had not
// come.
#include <gtest/gtest.h>

#include <cmath>

#include "framework/Controller.h"
#include "framework/OutputGuard.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/motion/JointRequest.h"
#include "support/InProcessServer.h"
#include "support/PerceptionModules.h"

namespace plumbline {
namespace {

using test::InProcessServer;

/// The text with the numbers behind `name` (all that are not words) replaced by `value`; every such list.
std::string withNumbers(std::string text, const std::string& name, const std::string& value) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) {
    at += name.size();
    const std::size_t end = text.find(')', at);
    std::string numbers;
    for (std::size_t i = at; i < end;) {
      while (i < end && text[i] == ' ') ++i;
      std::size_t stop = text.find(' ', i);
      stop = std::min(stop, end);
      if (stop > i) numbers += ' ' + value;
      i = stop;
    }
    text.replace(at, end - at, numbers);
    at += numbers.size();
  }
  return text;
}

struct Fault {
  const char* name;
  const char* list;  ///< whose numbers are replaced
  const char* value;
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

class BadMessages : public testing::TestWithParam<Fault> {
protected:
  BadMessages() : controller(ControllerOptions{}, test::playingModules()) {
    controller.objects().set(std::make_shared<AgentOptions>());
    controller.objects().set(source);
  }
  void play(int messages, bool bad) {
    for (int i = 0; i < messages; ++i) {
      source->text = server.message();
      if (bad) source->text = withNumbers(source->text, GetParam().list, GetParam().value);
      changed += source->text.find(GetParam().value) != std::string::npos;
      controller.runCycles(1);
      for (const double speed : controller.find<JointRequestWithSpeeds>()->speeds)
        ASSERT_TRUE(std::abs(speed) < 1e3) << "speed " << speed << ", message " << i;
      server.walk(Vec2(0.2, 0), 0);
    }
  }
  double positionError() {
    return (controller.find<RobotPose>()->pose.position - server.torso().translation().head<2>()).norm();
  }

  int changed = 0;
  InProcessServer server{InProcessServer::Setup{}};
  std::shared_ptr<test::MessageSource> source = std::make_shared<test::MessageSource>();
  Controller controller;
};

TEST_P(BadMessages, doNotStay) {
  play(250, false);
  ASSERT_TRUE(controller.find<RobotPose>()->valid);
  ASSERT_LT(positionError(), 0.3);
  changed = 0;
  play(3, true);  // one of them has an image
  ASSERT_GT(changed, 0);
  play(49, false);
  EXPECT_TRUE(controller.find<RobotPose>()->valid) << "within a second";
  EXPECT_LT(positionError(), 0.3);
  const TorsoAngles& torso = *controller.find<TorsoAngles>();
  bool numbers = false;
  EXPECT_TRUE(streamsFiniteNumbers(const_cast<TorsoAngles&>(torso), numbers));
  play(51, false);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadMessages,
    testing::Values(Fault{"pol1e100", "(pol", "1e100"}, Fault{"pol1e308", "(pol", "-1e308"},
                    Fault{"pol1e40", "(pol", "1e40"}, Fault{"polPlausible", "(pol", "150"},
                    Fault{"joints1e160", "(ax", "1e160"}, Fault{"joints1e308", "(ax", "-1e308"},
                    Fault{"gyro1e160", "(rt", "1e160"}, Fault{"acc1e160", "(a ", "1e160"},
                    Fault{"force1e200", "(f ", "1e200"}, Fault{"forcePoint1e100", "(c ", "1e100"},
                    Fault{"time1e300", "(now", "1e300"}, Fault{"gameTime1e300", "(t ", "1e300"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace plumbline
