#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/WindowKinds.h"

namespace plumbline::gap {

/// One channel in the windows of one group.
struct WindowCell {
  struct Part {
    std::size_t trial, signal, from, to;  ///< cycles [from, to)
  };
  std::size_t group = 0;
  int joint = -1;
  double noise = 0;  ///< standard deviation of its residuals under a perfect model
  std::vector<Part> windows;
  /// Per window: lower factor of the covariance that its coefficients have under a perfect model, by noise of
  /// the readings and by what the error of the measured state does.
  std::vector<Eigen::MatrixXd> factors;
  double share = 1;  ///< of an independent one, that a column counts for
};

/// Per cell: cosine coefficients of its residuals, a column per window. Those of a WindowReplayer are white:
/// under a perfect model they are independent and of variance 1.
using WindowCoefficients = std::vector<Eigen::MatrixXd>;

/// A pure function from a hypothesis to coefficients that a score is made of.
class CoefficientReplayer {
public:
  virtual ~CoefficientReplayer() = default;
  virtual WindowCoefficients coefficients(const Explanation& causes) const = 0;
  virtual const std::vector<WindowCell>& cells() const = 0;
  virtual const Groups& groups() const = 0;
  virtual const Mechanism& mechanism() const = 0;
  /// Those that the coefficients can show.
  virtual std::vector<WindowKind> kinds() const = 0;
  /// Columns count from now on for what they are worth beside what these causes leave; false where they
  /// always count alike.
  virtual bool weighBeside(const Explanation& /*causes*/) { return false; }
};

}  // namespace plumbline::gap
