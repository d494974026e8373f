#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/Density.h"

namespace plumbline::gap {

/// What a cell says about the values at which it was replayed, in logarithms of strengths. It is the
/// information of what varies about its mean, that of the mean, and the gradient of both. Information is
/// minus the second derivatives of the log density, as Gauss and Newton have them. Rows and columns of causes
/// that change nothing in it are 0.
struct CellInformation {
  std::size_t cell = 0;
  Eigen::MatrixXd about, mean;
  Eigen::VectorXd gradient;
};

/// Of each cell of the wanted groups (empty: all) that any cause changes, by differences about these values.
/// at: what they leave.
std::vector<CellInformation> informationOf(const Replayer& replayer, const Shares& shares,
                                           const Explanation& causes, const Residuals& at,
                                           const std::vector<char>& wantedGroups = {});

}  // namespace plumbline::gap
