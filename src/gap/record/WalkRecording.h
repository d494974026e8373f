#pragma once
#include <memory>
#include <string>

#include "gap/record/SimulatedRecording.h"
#include "training/ServoWalker.h"

namespace plumbline::gap {

/// A robot with these effects that walks in one of the engines for servo robots. Throws ConfigurationError
/// for an effect that is not one of drives, links or ground, std::invalid_argument for an unknown engine.
std::unique_ptr<training::ServoWalker> walkerWith(const std::string& engine, const Mechanism& robot,
                                                  const walking::WalkGaits& gaits,
                                                  const Explanation& effects);

/// Records a robot that walks with the project's own walk as the program says (Excitation::walk), closed
/// loop, in one of the engines for servo robots. The run has the walk's commands (cmd, stiffness) and the
/// readings with sensor noise; the walk itself gets readings without noise. Errors: std::invalid_argument for
/// another program, an unknown engine or a robot that is no humanoid; ConfigurationError for an effect that
/// is not one of drives, links or ground; std::runtime_error if the robot falls.
Run recordWalk(const std::string& engine, const Mechanism& robot, const Excitation& program,
               const SimulatedRecordingOptions& options);

}  // namespace plumbline::gap
