#include "gap/diagnosis/EvidenceMark.h"

#include <gtest/gtest.h>

#include <functional>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class EvidenceMarkTest : public ::testing::Test {
protected:
  static std::string markWith(const std::function<void(Mechanism&)>& change,
                              const std::function<void(Trial&)>& changeTrial = {},
                              const DiagnosisOptions& options = {}, const ReplayOptions& steps = {}) {
    Mechanism arm = twoJointArm();
    Trial trial = recorded(nominalPlant(arm), armTrial(arm, 1), 5e-4, 3);
    if (change) change(arm);
    if (changeTrial) changeTrial(trial);
    const Evidence evidence({trial});
    return markOf(Evaluator(arm, evidence, steps), options);
  }
  const std::string mark = markWith({});
};

TEST_F(EvidenceMarkTest, isTheSameForTheSame) {
  EXPECT_EQ(markWith({}), mark);
  DiagnosisOptions options;
  options.jobs = 7;  // decides nothing
  EXPECT_EQ(markWith({}, {}, options), mark);
}

TEST_F(EvidenceMarkTest, coversTheWholeModel) {
  using Change = std::function<void(Mechanism&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"inertia", [](Mechanism& m) { m.links[1].inertia(0, 1) += 1e-9; }},
      {"mass", [](Mechanism& m) { m.links[2].mass *= 1.1; }},
      {"gravity", [](Mechanism& m) { m.gravity.z() *= 1.3; }},
      {"axis", [](Mechanism& m) { m.joints[1].axis = -m.joints[1].axis; }},
      {"origin", [](Mechanism& m) { m.joints[1].origin.x() += 0.001; }},
      {"rpy", [](Mechanism& m) { m.joints[0].rpy.x() += 0.001; }},
      {"lower limit", [](Mechanism& m) { m.joints[0].lower = -2; }},
      {"encoder", [](Mechanism& m) { m.joints[0].encoder = Mechanism::Joint::Encoder::link; }},
      {"motor", [](Mechanism& m) { m.joints[0].servo.kt = 1.5; }},
      {"resistance", [](Mechanism& m) { m.joints[0].servo.R = 1.5; }},
      {"supply", [](Mechanism& m) { m.joints[0].servo.vin = 12; }},
      {"driver", [](Mechanism& m) { m.joints[1].driverRatio = 2; }},
      {"frames",
       [](Mechanism& m) {
         m.frames.push_back({"hand", 2, Pose3::Identity()});
       }},
      {"feet",
       [](Mechanism& m) {
         m.feet.push_back({"foot", 2, {}, {}, {}});
       }},
      {"inertial sensor", [](Mechanism& m) { m.imu.gyro.x() = 0.01; }},
      {"rate", [](Mechanism& m) { m.controlHz = 50; }}};
  for (const auto& [name, change] : changes) EXPECT_NE(markWith(change), mark) << name;
}

TEST_F(EvidenceMarkTest, coversAllData) {
  using Change = std::function<void(Trial&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"when commands arrive", [](Trial& t) { t.commandAt[1] += 0.001; }},
      {"when positions are read", [](Trial& t) { t.positionAt[1] += 0.001; }},
      {"a command", [](Trial& t) { t.command[0][50] += 1e-9; }},
      {"a reading", [](Trial& t) { t.signals[1].values[50] += 1e-9; }},
      {"stiffness", [](Trial& t) { t.stiffness[0].assign(t.cycles(), 0.5); }},
      {"a sign", [](Trial& t) { t.signals[0].unsignedValue = true; }},
      {"the motion's name", [](Trial& t) { t.motion = "other"; }},
      {"the servo as this run drove it", [](Trial& t) {
         Mechanism other = *t.robot;
         other.joints[0].servo.kp = 7;
         t.robot = std::make_shared<Mechanism>(other);
       }}};
  for (const auto& [name, change] : changes) EXPECT_NE(markWith({}, change), mark) << name;
}

TEST_F(EvidenceMarkTest, coversOptionsAndSteps) {
  DiagnosisOptions options;
  options.maxCauses = 2;
  EXPECT_NE(markWith({}, {}, options), mark);
  ReplayOptions steps;
  steps.step = 0.001;
  EXPECT_NE(markWith({}, {}, {}, steps), mark);
}

}  // namespace
}  // namespace plumbline::gap
