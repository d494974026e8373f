#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// The cause at each value that a search for its kind starts from, held within the effect's bounds.
std::vector<Cause> startsOf(const Mechanism& robot, const Cause& kind);

/// The least strength that a search for this kind of cause starts from.
double leastStart(const Mechanism& robot, const Cause& cause);

/// The cause with this strength (Effect::strengthOf), held within its effect's bounds.
Cause withStrength(const Mechanism& robot, Cause cause, double strength);

/// Logarithms of the strengths of causes (Effect::strengthOf), whose signs stay.
Eigen::VectorXd logStrengths(const Explanation& causes);

/// The causes with other strengths, held within their effects' bounds; a strength of less than a thousandth
/// of the least that a search starts from does nothing and is held there.
Explanation withLogStrengths(const Mechanism& robot, Explanation causes, const Eigen::VectorXd& x);

}  // namespace plumbline::gap
