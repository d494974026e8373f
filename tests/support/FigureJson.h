#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace plumbline::bench {

/// A figure of a benchmark as scripts/make_results.sh reads it.
inline nlohmann::json figureJson(const std::string& name, double value, const char* unit,
                                 const char* better) {
  return {{"name", name}, {"value", value}, {"unit", unit}, {"better", better}};
}

}  // namespace plumbline::bench
