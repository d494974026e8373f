#include "gap/inference/FreeCoefficients.h"

#include <cmath>

namespace plumbline::gap {

FreeCoefficients::FreeCoefficients(const Replayer& replayer)
    : replayer_(replayer), looked_(enoughTrials(replayer.groups())) {
  const Residuals nominal = replayer.residuals({}, looked_);
  for (std::size_t c = 0; c < groups().cells().size(); ++c) {
    const Cell& of = groups().cells()[c];
    if (!looked_[of.trial]) continue;
    const std::vector<double> residuals = residualsOf(of, nominal);
    CoefficientCell cell;
    cell.group = of.group;
    cell.joint = groups().trials()[of.trial].signals[of.signal].joint;
    cell.noise = of.noise;
    const std::size_t every = 1 + (of.to - of.from - 1) / enoughSamples;
    for (std::size_t k = 0; k < residuals.size(); ++k)
      if (std::isfinite(residuals[k]) && (of.from + k) % every == 0)
        cell.columns.push_back({of.trial, of.signal, of.from + k, of.from + k + 1});
    if (cell.columns.empty()) continue;
    sources_.push_back(c);
    CoefficientCell mean = cell;
    mean.columns.resize(1);
    cells_.push_back(std::move(mean));
    cells_.push_back(std::move(cell));
  }
  updateColumnShares({});
}

Coefficients FreeCoefficients::coefficients(const Explanation& causes) const {
  const Residuals residuals = replayer_.residuals(causes, looked_);
  Coefficients result;
  for (std::size_t i = 1; i < cells_.size(); i += 2) {
    const CoefficientCell& cell = cells_[i];
    const Series& series = residuals[cell.columns.front().trial][cell.columns.front().signal];
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(1, static_cast<Eigen::Index>(cell.columns.size()));
    for (std::size_t k = 0; k < cell.columns.size() && series; ++k)
      if (const double r = (*series)[cell.columns[k].from]; std::isfinite(r))
        values(0, static_cast<Eigen::Index>(k)) = r / cell.noise;
    const double mean = values.mean();
    result.emplace_back(Eigen::MatrixXd::Constant(1, 1, mean));
    result.emplace_back(values.array() - mean);
  }
  return result;
}

std::vector<CauseKind> FreeCoefficients::kinds() const { return causeKinds(groups(), mechanism()); }

bool FreeCoefficients::updateColumnShares(const Explanation& causes) {
  const Shares shares = sharesOf(groups(), replayer_.residuals(causes, looked_));
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Cell& of = groups().cells()[sources_[i]];
    cells_[2 * i + 1].share = shares[sources_[i]] * static_cast<double>(of.to - of.from) /
                              static_cast<double>(cells_[2 * i + 1].columns.size());
  }
  return true;
}

}  // namespace plumbline::gap
