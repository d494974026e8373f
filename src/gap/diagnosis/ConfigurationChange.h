#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// A servo may lose its settings with its supply, or be configured in another way on another day. So causes
/// that can be set in a servo (Effect::setting) become inactive (Cause::inactiveIn) in recordings that are
/// predicted far better without them; values are fitted again, and causes that are no longer needed go.
/// Returns the base itself where that holds for no recording, or for all that show the cause, or gains little
/// on the blocks for judging.
Explanation inactiveWhereNotSet(const Evaluator& evaluator, int jobs);

/// The one cause that can be set in a servo and explains most where it may be inactive in some recordings;
/// none where no cause makes some recordings far better and others far worse. nominal: an evaluator without
/// any cause.
Explanation configurationOfSome(const Evaluator& nominal, int jobs);

}  // namespace plumbline::gap
