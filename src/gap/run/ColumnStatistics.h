#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace plumbline::gap {

// Statistics of columns; lost samples (NaN) are ignored.

/// A number for people, four digits.
std::string shownNumber(double x);

struct Extremes {
  double low = 0, high = 0;
};
Extremes extremesOf(const std::vector<double>& column);
/// Share of the samples that are lost, 0..1.
double lostShare(const std::vector<double>& column);
/// Median of the differences of neighbours (the upper one of two); NaN of fewer than two values.
double medianStep(const std::vector<double>& t);
/// Median of the length of (x, y, z); NaN where there is no whole one.
double medianLength(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z);
/// Median of the sum of several columns.
double medianSum(const std::vector<const std::vector<double>*>& columns);

/// How two columns move together, without their means.
struct Likeness {
  std::size_t pairs = 0;
  double correlation = 0, rmsA = 0, rmsB = 0;
  double rangeB = 0;  ///< of b, without a hundredth at either end
};
Likeness likenessOf(const std::vector<double>& a, const std::vector<double>& b, const std::vector<bool>& use);

/// How far b is from a while a is beyond +-from: medians of |b - a| and of |a|.
struct Following {
  std::size_t pairs = 0;
  double distance = 0, size = 0;
};
Following followingOf(const std::vector<double>& a, const std::vector<double>& b, double from);
/// Largest speed between neighbouring samples, after an allowed jump is subtracted from their difference.
double fastest(const std::vector<double>& t, const std::vector<double>& column, double jump);

/// A recorded speed against the derivative of the position, at the lag (0 to 8 cycles) at which they agree
/// best.
struct SpeedLikeness {
  double correlation = 0;
  double slope = 0;  ///< speed recorded per speed derived
  double rms = 0;    ///< of the derived speed
};
SpeedLikeness speedLikeness(const std::vector<double>& t, const std::vector<double>& position,
                            const std::vector<double>& speed, double period);

/// Changes of the tilt sign * atan2(side, up) of the specific force over half a second (a) against the
/// integral of the rate over the same time (b).
Likeness tiltLikeness(const std::vector<double>& t, const std::vector<double>& side,
                      const std::vector<double>& up, const std::vector<double>& rate, double sign);

}  // namespace plumbline::gap
