#pragma once
#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The base's causes, those that can be set in a servo (Effect::setting) taken out of the recordings that are
/// predicted far better without them (Cause::notIn), values fitted anew: a servo that lost its settings with
/// its supply, or was set otherwise on another day, is not the same robot in all recordings. What is not
/// needed beside goes. The base itself where that holds for no recording or for all that show the cause, or
/// gains little on the blocks for judging.
Explanation withoutWhereNotSet(const Evaluator& evaluator, int jobs);

/// The one cause that can be set in a servo and explains most where it need not have been set in every
/// recording; none where no cause makes some recordings far better and others far worse. nominal: an
/// evaluator without any cause.
Explanation setInSomeRecordings(const Evaluator& nominal, int jobs);

}  // namespace plumbline::gap
