#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plumbline {

/// How much JSON a reader takes: a text may come from anyone, and what walks through it does so recursively.
struct JsonLimits {
  int depth = 16;                            ///< arrays and objects within each other
  std::size_t bytes = std::size_t{1} << 20;  ///< a whole number of MB
};

/// What is wrong with a text, as the rest of a sentence that begins with its file: "is nested deeper than 16
/// levels".
struct JsonError : std::runtime_error {
  explicit JsonError(const std::string& what, std::size_t line = 0) : std::runtime_error(what), line(line) {}
  std::size_t line;  ///< where a text is no JSON, from 1; 0: the text as a whole
};

/// The value that a text holds. Throws JsonError: "broken JSON" with its line, "is larger than 1 MB",
/// "is nested deeper than 16 levels", "key "a" occurs twice in one object", "holds a number that is too
/// large".
nlohmann::json parseJson(std::string_view text, const JsonLimits& limits = {});

/// The same of the text of a file that was read whole; the error begins with `path`, and the line if it is
/// known.
nlohmann::json parseJson(std::string_view text, const std::string& path,
                         const JsonLimits& limits = {.bytes = std::size_t{64} << 20});

}  // namespace plumbline
