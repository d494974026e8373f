#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/inference/CauseKinds.h"

namespace plumbline::gap {

/// One channel in some stretches of one group's trials: the smallest thing that is scored by itself.
struct CoefficientCell {
  struct Part {
    std::size_t trial, signal, from, to;  ///< cycles [from, to)
  };
  std::size_t group = 0;
  int joint = -1;
  double noise = 0;           ///< standard deviation of its residuals under a perfect model
  std::vector<Part> columns;  ///< the stretch that a column of coefficients is of
  double share = 1;           ///< of an independent one, that a column counts for
};

/// Per cell: coefficients of its residuals, a column per stretch; white under a perfect model: independent
/// and of variance 1.
using Coefficients = std::vector<Eigen::MatrixXd>;

/// Replays a hypothesis (causes with their values) and makes coefficients of what it leaves. The same causes
/// give the same coefficients.
class CoefficientReplayer {
public:
  virtual ~CoefficientReplayer() = default;
  virtual Coefficients coefficients(const Explanation& causes) const = 0;
  virtual const std::vector<CoefficientCell>& cells() const = 0;
  virtual const Groups& groups() const = 0;
  virtual const Mechanism& mechanism() const = 0;
  /// Those that the coefficients can show.
  virtual std::vector<CauseKind> kinds() const = 0;
  /// Sets the share that each column counts for, from what these causes leave. False where shares never
  /// change.
  virtual bool updateColumnShares(const Explanation& /*causes*/) { return false; }
};

}  // namespace plumbline::gap
