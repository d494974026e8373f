#include "walking/engine/BodyCommand.h"

#include <cmath>

namespace plumbline::walking {

void BodyCommand::placeArms(const WalkState& state, const WalkParameters& p) {
  const double stride = state.foot[0].x() - state.foot[1].x();
  for (const Side side : {Side::left, Side::right}) {
    const int arm = side == Side::left ? lShoulderPitch : rShoulderPitch;
    const double out = outward(side);
    double* joint = &angles_[static_cast<std::size_t>(arm)];
    joint[0] = p.arms.shoulderPitch + p.arms.swing * out * stride;
    joint[1] = out * p.arms.shoulderRoll;
    joint[2] = -out * p.arms.elbowYaw;
    joint[3] = -out * p.arms.elbowRoll;
  }
}

void BodyCommand::update(const WalkState& state, bool stepping, const SwingTrajectory& swing, double phase,
                         double lean, const TorsoTilt& tilt, const WalkParameters& p,
                         const JointArray& measured) {
  angles_[headYaw] = measured[headYaw];
  angles_[headPitch] = measured[headPitch];
  placeArms(state, p);
  std::array<FootPlacement, 2> feet;
  // The mass that leans out over the feet is brought back over them.
  const Vec2 lead = p.model.pendulumHeight * Vec2(p.feedback.comForwardGain * tilt.angle.y(),
                                                  -p.feedback.comSidewaysGain * tilt.angle.x());
  for (std::size_t i = 0; i < 2; ++i) {
    feet[i].ground = state.foot[i];
    feet[i].ground.position += lead;
  }
  if (stepping) {
    FootPlacement& foot = feet[index(other(state.supportSide()))];
    foot.height = swing.height * swing.lift(phase);
    foot.pitch = p.step.swingPitch * swing.lift(phase) - p.feedback.swingLevel * tilt.angle.y();
    foot.roll = -p.feedback.swingLevel * tilt.angle.x();
    // The body has turned about its mass, and the foot with it.
    const Vec2 turned =
        tilt.angle.cwiseProduct(Vec2(p.feedback.swingMeasuredRoll, p.feedback.swingMeasuredPitch));
    const Vec3 place(foot.ground.x(), foot.ground.y(), foot.height - posture_.comHeight());
    const Vec3 meant = (rotationX(-turned.x()) * rotationY(-turned.y())).linear() * place;
    foot.ground.position = meant.head<2>();
    foot.height = meant.z() + posture_.comHeight();
  }
  posture_.solve(feet, carriage(state, stepping, phase, lean, tilt, p), angles_);
  for (const Side side : {Side::left, Side::right}) {
    if (stepping && side != state.supportSide()) continue;
    double* leg = &angles_[static_cast<std::size_t>(firstLegJoint(side))];
    leg[1] += p.feedback.hipRollGain * tilt.angle.x() + p.feedback.hipRollRate * tilt.rate.x();
    leg[2] += p.feedback.hipPitchGain * tilt.angle.y() + p.feedback.hipPitchRate * tilt.rate.y();
    leg[4] += p.feedback.anklePitchGain * tilt.angle.y() + p.feedback.anklePitchRate * tilt.rate.y();
    leg[5] += p.feedback.ankleRollGain * tilt.angle.x() + p.feedback.ankleRollRate * tilt.rate.x();
  }
}

/// The torso's attitude and height. It leans to the supporting leg in the middle of a step; then either the
/// supporting hip or the middle of both, and with it the centre of mass, keeps its height (section 4.2.8).
TorsoPlacement BodyCommand::carriage(const WalkState& state, bool stepping, double phase, double lean,
                                     const TorsoTilt& tilt, const WalkParameters& p) const {
  TorsoPlacement torso;
  torso.pitch = lean + p.feedback.torsoMeasured * tilt.angle.y();
  torso.roll = p.feedback.torsoMeasured * tilt.angle.x();
  torso.hipHeight = p.posture.hipHeight;
  if (stepping && p.posture.torsoRoll != 0) {
    const double side = outward(state.supportSide());
    const double roll = p.posture.torsoRoll * std::sin(pi * phase);
    torso.roll -= side * roll;
    // Leaning to a leg lowers its hip under the middle.
    torso.hipHeight +=
        p.posture.constantHipHeight * std::abs(posture_.leg(Side::left).hip().y()) * std::sin(roll);
  }
  return torso;
}

}  // namespace plumbline::walking
