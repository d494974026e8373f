#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumbline::gap {

/// Reads an answer of bin/gap diagnose and checks what later commands need: a known verdict, causes with
/// effect, place and value. Throws ConfigurationError in one line that names file and field; files above 256
/// MB are refused.
nlohmann::json readAnswer(const std::string& path);

/// Reads and checks the output of bin/gap check --json: the share closed, and per run folder, before and
/// after.
nlohmann::json readCheck(const std::string& path);

}  // namespace plumbline::gap
