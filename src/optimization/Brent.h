#pragma once
#include <functional>

namespace plumbline {

/// Three places with the least value in the middle: lo < x < hi.
struct Bracket {
  double lo, x, hi;
  double fLo, fx, fHi;
};

/// Extends the bracket lo < x < hi towards the side on which f falls. Each step is 1.6 times the last, until
/// f rises, an end of [least, most] is reached, or the number of evaluations is used up. The middle has the
/// least value unless the search ended early. lo and hi have to be within [least, most].
Bracket bracketFrom(const std::function<double(double)>& f, double lo, double x, double hi, double least,
                    double most, int evaluations);

/// Place of a minimum of f within a bracket, to a tolerance or until the number of evaluations is used up.
/// Uses parabolas, and golden sections if they fail (Brent, Algorithms for Minimization without Derivatives,
/// 1973, chapter 5). Returns the best place tried.
double minimizeBrent(const std::function<double(double)>& f, const Bracket& bracket, double tolerance,
                     int evaluations);

}  // namespace plumbline
