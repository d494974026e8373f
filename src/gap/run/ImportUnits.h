#pragma once
#include <optional>
#include <string>

namespace plumbline::gap {

/// What one of a unit is in the run's unit (SI, rad); nothing for an unknown name.
std::optional<double> importUnit(const std::string& name);
/// All names, with a blank between.
std::string importUnitNames();

}  // namespace plumbline::gap
