#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// A servo may lose its settings without power, or have another configuration on another day. So causes that
/// can be set in a servo (Effect::setting) become inactive (Cause::inactiveIn) in recordings that are
/// predicted far better without them. Values are fitted again, and causes that are no longer needed are
/// removed. Returns the base itself if no recording, or every recording that shows the cause, is better
/// without it, or if the gain on the blocks for judging is small.
Explanation inactiveWhereNotSet(const Evaluator& evaluator, int jobs);

/// Of the causes that can be set in a servo, the one that explains most if it may be inactive in some
/// recordings. None if no cause makes some recordings far better and others far worse. nominal: an evaluator
/// without any cause.
Explanation configurationOfSome(const Evaluator& nominal, int jobs);

}  // namespace plumbline::gap
