#pragma once
#include <functional>

namespace plumbline {

/// Three places with the least value in the middle: lo < x < hi.
struct Bracket {
  double lo, x, hi;
  double fLo, fx, fHi;
};

/// Place of a minimum of f within a bracket, to a tolerance or until so many more values are taken:
/// parabolas, golden sections where they fail (Brent, Algorithms for Minimization without Derivatives, 1973,
/// chapter 5). Returns the best place tried.
double minimizeBrent(const std::function<double(double)>& f, const Bracket& bracket, double tolerance,
                     int evaluations);

}  // namespace plumbline
