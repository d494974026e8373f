#pragma once
#include <map>
#include <vector>

#include "robot/JointId.h"
#include "simulation/effects/EffectPlace.h"

namespace plumbline::simulation {

/// What one effect makes of the speeds that are commanded to one robot's joints.
class CommandEffect {
public:
  virtual ~CommandEffect() = default;
  /// Whether a joint's command is changed at all.
  virtual bool touches(JointId joint) const = 0;
  /// Once a cycle: commanded speeds of all joints [rad/s], as the effects before it leave them.
  virtual void cycle(JointArray& speeds) = 0;
  /// Angle of a joint's motor less that of its link [rad].
  virtual double slack(JointId) const { return 0; }
  /// At rest, nothing under way.
  virtual void restart() = 0;
};

/// A command effect at some joints, each by itself. OneJoint is made of the joint's settings and the cycle's
/// seconds, and has cycle(speed), which returns the speed that comes of it, slack() and restart().
template <typename OneJoint>
class JointCommandEffect : public CommandEffect {
public:
  JointCommandEffect(const std::vector<EffectSetting>& settings, double stepSeconds) {
    for (int j = 0; j < maxJoints; ++j)
      if (const auto here = settingsAt(settings, static_cast<JointId>(j)); !here.empty())
        joints_.emplace(static_cast<JointId>(j), OneJoint(here, stepSeconds));
  }
  bool touches(JointId joint) const override { return joints_.contains(joint); }
  void cycle(JointArray& speeds) override {
    for (auto& [joint, one] : joints_) speeds[joint] = one.cycle(speeds[joint]);
  }
  double slack(JointId joint) const override {
    const auto found = joints_.find(joint);
    return found == joints_.end() ? 0 : found->second.slack();
  }
  void restart() override {
    for (auto& [joint, one] : joints_) one.restart();
  }

private:
  std::map<JointId, OneJoint> joints_;
};

}  // namespace plumbline::simulation
