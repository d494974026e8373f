#pragma once
#include <span>
#include <string_view>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// What a model is given at every joint at once, as system identification does it.
struct PerJoint {
  Explanation causes;          ///< those kept, then one of each effect per motor
  std::size_t parameters = 0;  ///< of the latter
  double left = 1;             ///< squares of positions over the nominal model's, mean over recordings
};

/// The frictions that every joint may have: dry, viscous, at rest, by load.
std::span<const std::string_view> frictions();

/// One of each effect at every joint with a motor, beside a base of other causes. What the base has of these
/// effects is where a joint's value starts; elsewhere it starts at nominal. Throws std::invalid_argument for
/// an effect that is not of joints.
PerJoint perJoint(const Mechanism& robot, const Explanation& base, std::span<const std::string_view> effects);

/// Squares of what free replays leave of the positions over those that the nominal model leaves, the mean
/// over the recordings of a replayer's groups.
double shareLeft(const Replayer& replayer, const Explanation& causes);

/// Fits all values per joint to the positions by damped Gauss-Newton steps (Marquardt 1963), the base's
/// values held. A joint's derivatives are those of its own position: one replay per effect moves that effect
/// in all joints, and what joints do to each other is left to the next step.
PerJoint fitPerJoint(const Replayer& replayer, PerJoint start, int steps);

}  // namespace plumbline::gap
