#pragma once
#include "walking/estimation/WalkSensors.h"
#include "walking/model/WalkState.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// The soles' force sensors decide when a step ends: the swing foot becomes the support foot when it is
/// loaded, before its time or, if it has not reached the ground, a little after it. contact.share 0: steps
/// end as planned.
class SupportSwitch {
public:
  void reset() { share_ = {}; }
  /// The forces measured in this cycle.
  void update(const WalkSensors& sensors) {
    share_ = {};
    if (!sensors.feet) return;
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      for (const auto& part : {sensors.feet->foot[i], sensors.feet->toe[i]})
        if (part) share_[i] += part->force.z();
      sum += share_[i];
    }
    for (double& one : share_) one = sum > 0 ? one / sum : 0;
  }
  /// The rest of a step as the contact has it: over at once with the foot where it is, not before the time
  /// `left` of this cycle is over, or as it was planned.
  WalkAction adapted(WalkAction action, const WalkState& state, double phase, double elapsed, double left,
                     const WalkParameters& p) const {
    if (!(p.contact.share > 0)) return action;
    const std::size_t swing = index(other(state.supportSide()));
    const bool pressed = share_[swing] > p.contact.share;
    if (pressed && phase >= p.contact.minPhase && phase < 1) {
      action.duration = action.turn = 0;
      action.stepTarget = state.foot[swing];
    } else if (!pressed && action.duration <= left && elapsed + left < p.step.duration + p.contact.maxWait) {
      const double longer = left + 1e-6;
      if (action.duration > 0) action.turn *= longer / action.duration;
      action.duration = longer;
    }
    return action;
  }
  /// Share of the weight on the left and right sole; both 0 in the air.
  const std::array<double, 2>& shares() const { return share_; }

private:
  std::array<double, 2> share_{};
};

}  // namespace plumbline::walking
