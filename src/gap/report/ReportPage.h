#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// The page for an answer: the built page (scripts/build_page.sh) with the answer inside, and beside it what
/// the page draws from the robot, if that is known: a figure of it, and the effects' nominal values.
std::string reportPage(const std::string& builtPage, nlohmann::json answer,
                       const std::optional<Mechanism>& robot);

/// Text of the built page, found beside the program. Throws std::runtime_error that tells how to build it.
std::string builtReportPage();

}  // namespace plumbline::gap
