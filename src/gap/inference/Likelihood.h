#pragma once
#include <vector>

namespace plumbline::gap {

/// Degrees of freedom of the residuals' distribution: heavy tails, a mean square that exists.
inline constexpr double tailFreedom = 4;

/// Scale of Student-t residuals that is likeliest, not below a least one: the root of the squared noise and
/// the squared amplitude of the model's discrepancy (Kennedy and O'Hagan, "Bayesian calibration of computer
/// models", J. R. Stat. Soc. B 63, 2001). Residuals that are not finite are passed over.
double likeliestScale(const std::vector<double>& residuals, double least);

/// Sum of the logarithms of the density at that scale.
double logDensity(const std::vector<double>& residuals, double scale);

/// Derivative weight of one residual: minus d(log density)/dr = weight * r.
inline double weightOf(double residual, double scale) {
  return (tailFreedom + 1) / (tailFreedom * scale * scale + residual * residual);
}

/// Residuals of a stretch as their mean and what varies about it: however long the stretch is, its mean was
/// seen once.
struct Split {
  double mean = 0;
  std::vector<double> about;  ///< not finite where the residual is not
};
Split split(const std::vector<double>& residuals);

/// Scale of a stretch's mean: the likeliest of one value, not below the noise, nor below what the mean of so
/// many independent samples of this variation comes to. A mean nearer to zero than that is chance.
double scaleOfMean(double mean, double noise, double variation, double independent);

/// What a stretch of residuals says, but for how much its samples count. share: what a sample counts for, in
/// parts of an independent one (1 / correlationTime).
struct StretchFit {
  double scale = 0;  ///< of what varies about the mean: the likeliest one, not below the noise
  double about = 0;  ///< log density of what varies, each sample counted in full
  double mean = 0;
  double noise = 0;    ///< least scale of mean and variation
  double samples = 0;  ///< that are finite

  /// Logarithm of the density: mean and variation each at its scale, the variation by its share.
  double density(double share) const;
  double meanScale(double share) const;  ///< scaleOfMean()
};
StretchFit fitStretch(const Split& residuals, double noise);

/// Density of a stretch that is fitted for this alone.
inline double stretchDensity(const Split& residuals, double noise, double share) {
  return fitStretch(residuals, noise).density(share);
}

/// How many successive residuals say as much as one that is independent: 1 + 2 * sum of autocorrelations, by
/// the initial positive sequence (Geyer, "Practical Markov chain Monte Carlo", Stat. Science 7, 1992); at
/// least 1.
double correlationTime(const std::vector<double>& residuals);

/// The correlation time by which a likeliest scale is uncertain. The noise is known and white: what is beyond
/// it has to be estimated, and counts by its share of the variance. At the noise: 1.
double timeOfScale(double correlationTime, double scale, double noise);

}  // namespace plumbline::gap
