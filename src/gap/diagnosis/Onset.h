#pragma once
#include <optional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// For an effect that begins at a moment (Effect::setsIn): the value with which it begins when the readings
/// leave the base. Bisection finds it in the run with a fixed base that shows most. A normal fit would miss
/// it, because its valley is too narrow: a motor that becomes too weak a second too early never catches up.
/// Returns nothing if the readings differ from the start, or never, or if no value begins so early.
std::optional<Cause> causeByOnset(const Evaluator& evaluator, const Cause& start);

}  // namespace plumbline::gap
