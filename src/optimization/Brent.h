#pragma once
#include <functional>

namespace plumbline {

/// Three places with the least value in the middle: lo < x < hi.
struct Bracket {
  double lo, x, hi;
  double fLo, fx, fHi;
};

/// Bracket from lo < x < hi on: goes on to the side where f falls, each step 1.6 times the last, until it
/// rises there, an end of [least, most] is reached or so many more values are taken. The middle is the least
/// value unless it ended early. lo and hi have to be within [least, most].
Bracket bracketFrom(const std::function<double(double)>& f, double lo, double x, double hi, double least,
                    double most, int evaluations);

/// Place of a minimum of f within a bracket, to a tolerance or until so many more values are taken:
/// parabolas, golden sections where they fail (Brent, Algorithms for Minimization without Derivatives, 1973,
/// chapter 5). Returns the best place tried.
double minimizeBrent(const std::function<double(double)>& f, const Bracket& bracket, double tolerance,
                     int evaluations);

}  // namespace plumbline
