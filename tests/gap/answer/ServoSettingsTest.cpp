#include "gap/answer/ServoSettings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../TwoJointArm.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

Trial withGain(double kp) {
  Mechanism arm = twoJointArm();
  arm.joints[1].servo.kp = kp;
  return armTrial(arm, 1);
}

TEST(ServoSettingsTest, theLeastAndTheLargestOfEachSetting) {
  Trial first = withGain(15);
  first.command[0].clear();
  const ServoSettings settings = servoSettings({first, withGain(30)});
  EXPECT_EQ(settingsJson(settings).dump(),
            R"({"elbow":{"kd":[0.4,0.4],"kp":[15.0,30.0]},"shoulder":{"kd":[0.4,0.4],"kp":[20.0,20.0]}})");
  EXPECT_EQ(settingsJson(settingsIn(settingsJson(settings))), settingsJson(settings));
  EXPECT_EQ(settingsJson(servoSettings({armTrial(findMechanism("xl330_pendulum"), 1)})).dump(),
            R"({"pendulum":{"kp_firmware":[400.0,400.0],"vin":[7.4,7.4]}})");
}

TEST(ServoSettingsTest, whatNoneOfTheOthersHadIsBeyond) {
  const ServoSettings others = servoSettings({withGain(15), withGain(30)});
  EXPECT_TRUE(settingsBeyond(others, {withGain(20)}).empty());
  EXPECT_EQ(settingsBeyond(others, {withGain(40)}),
            std::vector<std::string>{"kp of elbow is 40 here, and 15 to 30 in the recordings of the answer"});
  EXPECT_EQ(settingsBeyond(servoSettings({withGain(15)}), {withGain(10), withGain(20)}),
            std::vector<std::string>{"kp of elbow is 10 to 20 here, and 15 in the recordings of the answer"});
}

TEST(ServoSettingsTest, anAnswerWithoutThemLeavesItOpen) {
  EXPECT_TRUE(settingsBeyond(settingsIn(nlohmann::json()), {withGain(40)}).empty());
  EXPECT_TRUE(
      settingsBeyond(settingsIn({{"elbow", {{"kp", "many"}}}, {"shoulder", 3}}), {withGain(40)}).empty());
}

}  // namespace
}  // namespace plumbline::gap
