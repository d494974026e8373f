#pragma once
#include <string>
#include <vector>

#include "gap/TwoJointArm.h"
#include "gap/blind/Planting.h"
#include "gap/record/ExcitationFile.h"
#include "gap/record/SimulatedRecording.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

/// Stands for recordings of a real arm: a robot of which the model lacks friction, with noise of its own.
inline RealRecordings realRecordings(const Mechanism& robot, const std::string& joint) {
  std::vector<Run> runs;
  for (const char* program : {"hang_sweep", "hang_multisine"}) {
    SimulatedRecordingOptions options;
    options.effects = {
        causeOf(robot, "coulomb_friction", joint.c_str(),
                0.03 * robot.joints[static_cast<std::size_t>(robot.jointIndex(joint))].maxTorque)};
    options.seed = runs.size() + 1;
    Run run = recordSimulated(robot, findExcitation(program, robot), options);
    run.folder = program;
    runs.push_back(std::move(run));
  }
  return {robot, std::move(runs)};
}

inline const RealRecordings& realArm() {
  static const RealRecordings one = realRecordings(readMechanism("tests/e2e/gap/arm.json"), "Elbow");
  return one;
}

}  // namespace plumbline::gap
