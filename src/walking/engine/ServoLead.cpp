#include "walking/engine/ServoLead.h"

#include <algorithm>

namespace plumbline::walking {

ServoLead::ServoLead(const Mechanism& mechanism)
    : mechanism_(mechanism), robot_(mechanism_), load_(robot_.model()) {
  reset();
}

void ServoLead::reset() {
  begun_ = false;
  share_ = {0.5, 0.5};
  command_.target.assign(mechanism_.joints.size(), 0);
  command_.stiffness.assign(mechanism_.joints.size(), 1);
}

const ServoCommand& ServoLead::command(const ServoTargets& wanted, const WalkParameters& p,
                                       const Vec2& torsoAngles, double dt) {
  // The weight goes from foot to foot within a few cycles.
  constexpr double shiftTime = 0.03;  // [s]
  const double most = dt / shiftTime;
  share_[0] += std::clamp(wanted.leftShare - share_[0], -most, most);
  share_[1] = 1 - share_[0];
  const JointArray& torque = load_.update(wanted.angles, torsoAngles, share_, p.model.pressure());
  for (std::size_t j = 0; j < maxJoints; ++j) {
    const int index = robot_.mechanismJoint(static_cast<JointId>(j));
    if (index < 0) continue;
    const Mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(index)];
    const double kp = joint.servo.kp * std::max(0.1, wanted.stiffness[j]);
    double target = wanted.set[j] ? wanted.angles[j] : 0;
    if (wanted.set[j] && kp > 0) {
      const double rate = begun_ ? (wanted.angles[j] - last_[j]) / dt : 0;
      target += p.servo.loadLead * torque[j] / kp +
                p.servo.rateLead * (joint.servo.kd + joint.damping) / joint.servo.kp * rate;
    }
    command_.target[static_cast<std::size_t>(index)] = std::clamp(target, joint.lower, joint.upper);
    command_.stiffness[static_cast<std::size_t>(index)] = wanted.stiffness[j];
  }
  last_ = wanted.angles;
  begun_ = true;
  return command_;
}

}  // namespace plumbline::walking
