#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "gap/record/SimulatedRecording.h"
#include "simulation/servo/RobotSimulation.h"

namespace plumbline::gap {

/// What a robot in an engine has that no effect of the library says: it may change what joints are told, and
/// push them. One per recording.
class OutsideEffects {
public:
  virtual ~OutsideEffects() = default;
  /// Before the recording: the first commands of all joints [rad].
  virtual void start(const std::vector<double>& commands) = 0;
  /// Before a slice of h [s] from this time on: may change targets [rad] and put loads on joints.
  virtual void act(double time, double h, simulation::RobotSimulation& world,
                   std::vector<double>& targets) = 0;
  /// [m/s^2], the sensor's axes.
  virtual Vec3 accBias() const { return Vec3::Zero(); }
};

/// The same as recordSimulated, but the robot lives in one of the engines for servo robots
/// (simulation/servo/RobotSimulation.h), which the diagnosis does not use to explain: hung up, or put on its
/// feet, settled in the first posture for a second. Its drives are written apart from those that explain.
/// Errors: ConfigurationError for two external forces, std::invalid_argument for an engine that there is not
/// and for a program on feet that the robot lacks.
Run recordInEngine(const std::string& engine, const Mechanism& robot, const Excitation& program,
                   const SimulatedRecordingOptions& options = {}, OutsideEffects* outside = nullptr);

/// A plant as an engine takes it: its drives and links, gravity seen from its ground, and the ground itself.
/// A joint that shares another's motor has a servo of its own, to be told the same, as in the replay and the
/// contract's law. step: of the physics [s].
Mechanism engineMechanism(const Plant& plant, double controlHz);
simulation::RobotSimulationOptions engineOptions(const Plant& plant, bool fixedBase, double step = 0.001);

}  // namespace plumbline::gap
