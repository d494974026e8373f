#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "gap/record/SimulatedRecording.h"
#include "servo/RobotSimulation.h"

namespace plumbline::gap {

/// Effects of a robot in an engine that the library does not have: they may change the joints' commands and
/// put loads on joints. One object per recording.
class OutsideEffects {
public:
  virtual ~OutsideEffects() = default;
  /// Before the recording: the first commands of all joints [rad].
  virtual void start(const std::vector<double>& commands) = 0;
  /// Called before a step of h [s] at this time: may change targets [rad] and put loads on joints.
  virtual void act(double time, double h, servo::RobotSimulation& world, std::vector<double>& targets) = 0;
  /// [m/s^2], the sensor's axes.
  virtual Vec3 accBias() const { return Vec3::Zero(); }
};

/// The same as recordSimulated, but in one of the engines for servo robots
/// (servo/RobotSimulation.h), which the diagnosis does not use. The robot is hung up or put on its
/// feet, and settles in the first posture for a second. Its drives are implemented separately from those of
/// the diagnosis. Errors: ConfigurationError for two external forces, std::invalid_argument for an unknown
/// engine and for a program on the feet with a robot without feet.
Run recordInEngine(const std::string& engine, const Mechanism& robot, const Excitation& program,
                   const SimulatedRecordingOptions& options = {}, OutsideEffects* outside = nullptr);

/// A plant for an engine: its drives and links, gravity relative to its ground, and the ground itself. A
/// joint that shares another's motor has its own servo, which must get the same commands, as in the replay.
/// step: of the physics [s].
Mechanism engineMechanism(const Plant& plant, double controlHz);
servo::RobotSimulationOptions engineOptions(const Plant& plant, bool fixedBase, double step = 0.001);

}  // namespace plumbline::gap
