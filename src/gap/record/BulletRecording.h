#pragma once
#include <string_view>
#include <vector>

#include "gap/record/SimulatedRecording.h"
#include "simulation/servo/ServoWorld.h"

namespace plumbline::gap {

/// The same as recordSimulated, but the robot lives in Bullet (simulation/servo/ServoWorld.h), an engine that
/// the diagnosis does not use to explain: hung up, or put on its feet, settled in the first posture for a
/// second. Delays are kept to 1 ms. Errors: ConfigurationError for an effect that this engine does not have
/// (it names those it has), std::invalid_argument for a program on feet that the robot lacks.
Run recordBullet(const Mechanism& robot, const Excitation& program,
                 const SimulatedRecordingOptions& options = {});

/// A plant as ServoWorld takes it: its drives and links, gravity seen from its ground, and the ground itself.
/// A joint that shares another's motor has a servo of its own, to be told the same, as in the replay and the
/// contract's law.
Mechanism bulletMechanism(const Plant& plant, double controlHz);
simulation::ServoWorldConfig bulletWorld(const Plant& plant, bool fixedBase);

/// Ids of the effects that recordBullet has, and of those that a walk in Bullet has: of drives, links,
/// ground.
const std::vector<std::string_view>& bulletEffects();
const std::vector<std::string_view>& walkEffects();

}  // namespace plumbline::gap
