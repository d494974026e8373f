#pragma once
#include <Eigen/Core>

#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// Logarithms of the strengths of causes (Effect::strengthOf), whose signs stay.
Eigen::VectorXd logStrengths(const Explanation& causes);

/// The causes with other strengths, held within their effects' bounds; a strength of less than a thousandth
/// of the least that a search starts from does nothing and is held there.
Explanation withLogStrengths(const Mechanism& robot, Explanation causes, const Eigen::VectorXd& x);

}  // namespace plumbline::gap
