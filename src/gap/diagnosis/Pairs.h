#pragma once
#include <functional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Whether one motor moves all of the robot, so that each effect looks much like the others.
bool hasOneMotor(const Mechanism& robot);
/// Whether all causes move the same joints of a robot with a fixed base.
bool onOneChain(const Evaluator& evaluator, const Explanation& causes);

/// The two causes that predict best together, values fitted together; empty if no two are possible. If two
/// causes are present, the one that fits best alone may be neither of them, and forward selection would keep
/// it. All pairs are screened by what their signatures explain together, as if effects were linear; the most
/// promising are fitted. fine, coarse: with the nominal base, which stays.
Explanation bestPair(const Evaluator& fine, const Evaluator& coarse, int jobs,
                     const std::function<void(double share)>& progress = {});

}  // namespace plumbline::gap
