#pragma once
#include "TwoJointArm.h"

namespace plumbline::gap {

/// The two-joint arm as a leg: a body of 1 kg on a wide sole that its lower link ends in.
inline Mechanism legOnItsFoot() {
  Mechanism leg = twoJointArm();
  leg.name = "standing_leg";
  leg.links[0].mass = 1;
  leg.joints[0].origin = Vec3::Zero();
  leg.joints[0].name = "hip";
  leg.joints[1].name = "knee";
  Mechanism::Foot foot;
  foot.name = "Foot";
  foot.link = 2;
  foot.soleCentre = Vec3(0, 0, -0.2);
  foot.soleSize = Vec3(0.3, 0.3, 0);
  leg.feet.push_back(foot);
  return leg;
}

/// The ground below the leg is inclined about y [rad].
inline Cause groundSlope(double angle) {
  const Effect& slope = *findEffect("ground_slope");
  return {&slope, findPlace(slope, legOnItsFoot(), "ground", "y"), angle, 0};
}

/// armTrial() of small motions, hung up or on the foot.
inline Trial legTrial(bool floatingBase, double seconds = 6) {
  Trial trial = armTrial(legOnItsFoot(), seconds, floatingBase ? 0.05 : 0.4);
  trial.freeBase = floatingBase;
  if (floatingBase) trial.motion = "on the foot";
  return trial;
}

/// Three motions hung up and two on the foot, with the causes in.
inline std::vector<Trial> legRecordings(const Explanation& causes, double seconds = 4) {
  std::vector<Trial> trials;
  for (const bool stands : {false, false, false, true, true}) {
    Trial trial = legTrial(stands, seconds);
    const double size = 1 - 0.2 * static_cast<double>(trials.size() % 3);
    for (std::vector<double>& commands : trial.command)
      for (double& command : commands) command *= size;
    trial.recording = trial.name = "run" + std::to_string(trials.size());
    trials.push_back(recorded(plantOf(legOnItsFoot(), causes), trial, 5e-4, 3 + trials.size()));
  }
  return trials;
}

}  // namespace plumbline::gap
