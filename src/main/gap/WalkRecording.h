#pragma once
#include <string>
#include <vector>

#include "gap/record/SimulatedRecording.h"

namespace plumbline::gap {

/// Walks that `--program` knows beside the files: walk_forward, walk_sideways, walk_turn.
const std::vector<std::string>& walkPrograms();

/// A robot walks with the project's own engine, closed loop, in Bullet (training/ServoWalker.h): 1 s of
/// standing, 10 s of walking, 1 s of standing. The run has what the engine commanded (cmd, stiffness) and
/// what was read, with the sensors' noise, which the engine itself does not see. Errors:
/// std::invalid_argument for another name or a robot that is no humanoid; ConfigurationError for an effect
/// that is neither of drives, links nor ground; std::runtime_error where the robot falls.
Run recordWalk(const Mechanism& robot, const std::string& program, const SimulatedRecordingOptions& options);

}  // namespace plumbline::gap
