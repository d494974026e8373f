#include "gap/run/ImportUnits.h"

#include <cmath>
#include <map>

namespace plumbline::gap {
namespace {

constexpr double standardGravity = 9.80665;

const std::map<std::string, double>& units() {
  static const std::map<std::string, double> table = {{"1", 1},
                                                      {"rad", 1},
                                                      {"deg", M_PI / 180},
                                                      {"turn", 2 * M_PI},
                                                      {"rad/s", 1},
                                                      {"deg/s", M_PI / 180},
                                                      {"rpm", M_PI / 30},
                                                      {"m", 1},
                                                      {"mm", 1e-3},
                                                      {"m/s", 1},
                                                      {"mm/s", 1e-3},
                                                      {"m/s^2", 1},
                                                      {"g", standardGravity},
                                                      {"N", 1},
                                                      {"kgf", standardGravity},
                                                      {"Nm", 1},
                                                      {"mNm", 1e-3},
                                                      {"A", 1},
                                                      {"mA", 1e-3},
                                                      {"V", 1},
                                                      {"mV", 1e-3},
                                                      {"percent", 1e-2},
                                                      {"s", 1},
                                                      {"ms", 1e-3},
                                                      {"us", 1e-6},
                                                      {"ns", 1e-9},
                                                      {"C", 1}};
  return table;
}

}  // namespace

std::optional<double> importUnit(const std::string& name) {
  const auto it = units().find(name);
  return it == units().end() ? std::nullopt : std::optional(it->second);
}

std::string importUnitNames() {
  std::string list;
  for (const auto& [unit, factor] : units()) list += (list.empty() ? "" : " ") + unit;
  return list;
}

}  // namespace plumbline::gap
