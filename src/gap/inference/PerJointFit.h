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

/// Normal prior on values per joint, in units of the least strength that a search starts from: what a squared
/// distance costs, as a share of the squares that the nominal model leaves. own: of a joint from the value
/// that all joints have in common; common: of that from nominal. 0: no prior.
struct Shrinkage {
  double own = 0, common = 0;
};

/// The effects of causes that sit at joints, each once.
std::vector<const Effect*> kindsAtJoints(const Explanation& causes);

/// One of each effect at every joint with a motor, added to a base of other causes. A joint's value starts
/// where the base has that effect, otherwise at nominal. Throws std::invalid_argument for
/// an effect that is not of joints.
PerJoint perJoint(const Mechanism& robot, const Explanation& base, std::span<const Effect* const> effects);
PerJoint perJoint(const Mechanism& robot, const Explanation& base, std::span<const std::string_view> ids);

/// Squares of what free replays leave of the positions over those that the nominal model leaves, the mean
/// over the recordings of a replayer's groups.
double shareLeft(const Replayer& replayer, const Explanation& causes);

/// Fits all values per joint to the positions by damped Gauss-Newton steps (Marquardt 1963), the base's
/// values held. A joint's derivatives are those of its own position: one replay per effect moves that effect
/// in all joints, and what joints do to each other is left to the next step. With a prior, what all joints
/// have in common is the likeliest for them (a hierarchical model: Gelman et al., Bayesian Data Analysis,
/// chapter 5).
PerJoint fitPerJoint(const Replayer& replayer, PerJoint start, int steps, const Shrinkage& prior = {});

}  // namespace plumbline::gap
