#pragma once
#include <optional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// The value with which an effect that sets in at a moment (Effect::setsIn) sets in when the readings leave
/// the base: found by bisection of that moment, in the run with a held base that shows most. Its fit has a
/// valley too narrow to be met by chance: a motor that falls short a second too soon stays behind for good.
/// Nothing where the readings leave the base from the start, or never, or no value sets in as soon.
std::optional<Cause> causeByOnset(const Evaluator& evaluator, const Cause& start);

}  // namespace plumbline::gap
