#pragma once
#include <memory>
#include <string>

#include "gap/record/SimulatedRecording.h"
#include "training/ServoWalker.h"

namespace plumbline::gap {

/// A robot that walks in one of the engines for servo robots and has these effects. Throws ConfigurationError
/// for an effect that is neither of drives, links nor ground, std::invalid_argument for an engine that there
/// is not.
std::unique_ptr<walking::ServoWalker> walkerWith(const std::string& engine, const Mechanism& robot,
                                                 const walking::WalkGaits& gaits, const Explanation& effects);

/// A robot walks with the project's own walk as the program says (Excitation::walk), closed loop, in one of
/// the engines for servo robots. The run has what the walk commanded (cmd, stiffness) and what was read, with
/// the sensors' noise, which the walk itself does not see. Errors: std::invalid_argument for another program,
/// an engine that there is not or a robot that is no humanoid; ConfigurationError for an effect that is
/// neither of drives, links nor ground; std::runtime_error where the robot falls.
Run recordWalk(const std::string& engine, const Mechanism& robot, const Excitation& program,
               const SimulatedRecordingOptions& options);

}  // namespace plumbline::gap
