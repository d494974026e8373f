#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// The page for an answer: the built page (scripts/build_page.sh) with the answer inside. If the robot is
/// known, it also contains what the page draws: a figure of the robot, and the nominal values of the effects.
std::string reportPage(const std::string& builtPage, nlohmann::json answer,
                       const std::optional<Mechanism>& robot);

/// Text of the built page, found next to the program. Throws std::runtime_error that says how to build it.
std::string builtReportPage();

}  // namespace plumbline::gap
