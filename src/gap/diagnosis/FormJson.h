#pragma once
#include <nlohmann/json_fwd.hpp>

#include "gap/diagnosis/Explanation.h"

namespace plumbline::gap {

/// All of a cause but its value, as files of stopped diagnoses have it.
nlohmann::json jsonOfForm(const Cause& cause);

/// The same with the value 0. Throws std::exception for what the library or the robot lacks.
Cause formOf(const nlohmann::json& form, const Mechanism& robot);

}  // namespace plumbline::gap
