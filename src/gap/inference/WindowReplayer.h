#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "gap/inference/CoefficientReplayer.h"
#include "gap/inference/Replayer.h"
#include "gap/inference/WindowStarts.h"

namespace plumbline::gap {

/// The orthonormal cosine transform (DCT-II) of stretches of one length, at most so many first coefficients:
/// its cosines, which take longer than the sums.
class CosineBasis {
public:
  CosineBasis(std::size_t length, std::size_t most);
  /// Of the stretch that begins there.
  Eigen::VectorXd coefficients(const ResidualSeries& residuals, std::size_t from) const;

private:
  template <std::size_t pairs>
  void addUp(const double* values, std::size_t first, double* sums) const;

  std::size_t length_, count_;
  std::vector<double> values_;  ///< per sample and coefficient
};

/// Residuals of recordings that are replayed in windows from the measured state, for robots whose base is
/// held. What a free replay adds up over seconds, a window forgets.
class WindowReplayer : public CoefficientReplayer {
public:
  /// groups: of the recordings as they are; they must outlive it.
  WindowReplayer(const Mechanism& robot, const Groups& groups, int jobs);
  /// The same without one group (Groups::without); shares what was replayed.
  WindowReplayer(const WindowReplayer& whole, std::size_t leftOut);

  Coefficients coefficients(const Explanation& causes) const override;
  const std::vector<CoefficientCell>& cells() const override { return cells_; }
  const Groups& groups() const override { return *groups_; }
  const Mechanism& mechanism() const override { return plain_->mechanism(); }
  std::vector<CauseKind> kinds() const override { return windowKinds(groups(), mechanism()); }
  std::size_t numAsked() const;  ///< see Replayer

private:
  void layOut();
  void putFactors();
  Coefficients plainCoefficients(const Replayer& replayer, const Explanation& causes) const;

  std::shared_ptr<const std::vector<std::vector<Window>>> windows_;  ///< per trial
  std::shared_ptr<const Groups> groups_, groupsMoved_, groupsHurried_;
  /// From the starts as measured, and with all positions or speeds of the starts shifted.
  std::shared_ptr<const Replayer> plain_, moved_, hurried_;
  std::vector<CoefficientCell> cells_;
  /// Per cell and window: lower factor of the covariance that its coefficients have under a perfect model, by
  /// noise of the readings and by what the error of the measured state does.
  std::vector<std::vector<Eigen::MatrixXd>> factors_;
};

}  // namespace plumbline::gap
