#pragma once
#include <functional>

namespace plumbline::gap {

/// Reports of a part of something, as reports of the whole [shares]. whole must outlive it; null: nobody
/// listens.
inline std::function<void(double)> partOf(const std::function<void(double)>& whole, double from, double to) {
  if (!whole) return {};
  return [&whole, from, to](double share) { whole(from + (to - from) * share); };
}

}  // namespace plumbline::gap
