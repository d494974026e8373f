#include "optimization/Brent.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

Bracket bracketFrom(const std::function<double(double)>& f, double lo, double x, double hi, double least,
                    double most, int evaluations) {
  constexpr double growth = 1.6;
  Bracket b{lo, x, hi, 0, f(x), 0};
  b.fLo = f(lo);
  b.fHi = f(hi);
  for (int i = 0; i < evaluations && (b.fLo < b.fx || b.fHi < b.fx); ++i) {
    if (b.fLo < b.fx) {
      if (b.lo <= least) break;
      b = {std::max(least, b.lo - growth * (b.x - b.lo)), b.lo, b.x, 0, b.fLo, b.fx};
      b.fLo = f(b.lo);
    } else {
      if (b.hi >= most) break;
      b = {b.x, b.hi, std::min(most, b.hi + growth * (b.hi - b.x)), b.fx, b.fHi, 0};
      b.fHi = f(b.hi);
    }
  }
  return b;
}

double minimizeBrent(const std::function<double(double)>& f, const Bracket& bracket, double tolerance,
                     int evaluations) {
  constexpr double golden = 0.381966;
  // x: best so far, w: second best, v: w before that.
  const bool left = bracket.fLo < bracket.fHi;
  double x = bracket.x, w = left ? bracket.lo : bracket.hi, v = left ? bracket.hi : bracket.lo;
  double fx = bracket.fx, fw = left ? bracket.fLo : bracket.fHi, fv = left ? bracket.fHi : bracket.fLo;
  double lo = bracket.lo, hi = bracket.hi, step = 0, stepBefore = 0;
  for (int i = 0; i < evaluations; ++i) {
    const double middle = (lo + hi) / 2;
    if (std::abs(x - middle) <= 2 * tolerance - (hi - lo) / 2) break;
    bool parabola = false;
    if (std::abs(stepBefore) > tolerance || i == 0) {
      const double r = (x - w) * (fx - fv), q0 = (x - v) * (fx - fw);
      double p = (x - v) * q0 - (x - w) * r, q = 2 * (q0 - r);
      if (q > 0) p = -p;
      q = std::abs(q);
      if (q > 0 && p > q * (lo - x) && p < q * (hi - x) &&
          (i == 0 || std::abs(p) < std::abs(0.5 * q * stepBefore))) {
        stepBefore = step;
        step = p / q;
        parabola = true;
      }
    }
    if (!parabola) {
      stepBefore = x < middle ? hi - x : lo - x;
      step = golden * stepBefore;
    }
    const double u = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const double fu = f(u);
    if (fu <= fx) {
      (u < x ? hi : lo) = x;
      v = w, fv = fw, w = x, fw = fx, x = u, fx = fu;
    } else {
      (u < x ? lo : hi) = u;
      if (fu <= fw || w == x) {
        v = w, fv = fw, w = u, fw = fu;
      } else if (fu <= fv || v == x || v == w) {
        v = u, fv = fu;
      }
    }
  }
  return x;
}

}  // namespace plumbline
