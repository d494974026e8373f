#include "fuzz/Targets.h"

#include <algorithm>

namespace plumbline::fuzz {
namespace {

std::vector<Target>& all() {
  static std::vector<Target> one;
  return one;
}

}  // namespace

Registered::Registered(const Target& target) { all().push_back(target); }

const std::vector<Target>& targets() {
  // Static objects of several files have no order.
  static const std::vector<Target> sorted = [] {
    std::vector<Target> list = all();
    std::ranges::sort(list, {}, [](const Target& target) { return std::string_view(target.name); });
    return list;
  }();
  return sorted;
}

}  // namespace plumbline::fuzz
