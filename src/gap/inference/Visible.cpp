#include "gap/inference/Visible.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Density.h"

namespace plumbline::gap {

bool isVisible(const Replayer& replayer, const Explanation& causes, std::size_t i) {
  const Residuals with = replayer.residuals(causes), rest = replayer.residuals(without(causes, i));
  return std::ranges::any_of(replayer.groups().cells(), [&](const Cell& cell) {
    const std::vector<double> a = residualsOf(cell, with), b = residualsOf(cell, rest);
    double sum = 0, squares = 0, n = 0;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
      if (const double d = a[k] - b[k]; std::isfinite(d)) sum += d, squares += d * d, ++n;
    return n > 0 && std::sqrt(squares / n) > enginesDiffer * cell.noise;
  });
}

}  // namespace plumbline::gap
