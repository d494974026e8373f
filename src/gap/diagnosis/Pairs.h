#pragma once
#include <functional>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Whether one motor moves all of the robot, so that each effect looks much like the others.
bool hasOneMotor(const Mechanism& robot);
/// Whether causes all move the same joints of a robot whose base is held.
bool onOneChain(const Evaluator& evaluator, const Explanation& causes);

/// The two causes that predict best together, values fitted together; empty where no two are possible. Of two
/// that are there the one that fits best alone may be neither, and causes added one at a time stay with it.
/// All pairs are looked at by what their signatures explain together as if effects were linear; the most
/// promising are fitted. fine, coarse: with the nominal base, which stays.
Explanation bestPair(const Evaluator& fine, const Evaluator& coarse, int jobs,
                     const std::function<void(double share)>& progress = {});

}  // namespace plumbline::gap
