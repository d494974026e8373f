// JSON from anyone, within its limits; what an agent says of itself in lines.
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "fuzz/Readers.h"
#include "game/StatusReader.h"

namespace plumbline::fuzz {
namespace {

void json(std::string_view bytes) {
  refusesInOneLine([&] {
    const nlohmann::json value = parseJson(bytes, JsonLimits{.depth = 8, .bytes = 1 << 20});
    const std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    require(parseJson(text, JsonLimits{.depth = 8, .bytes = 4 << 20}) == value,
            "a value changes when it is read back");
  });
  refusesInOneLine([&] { parseJson(bytes, "file.json"); });
}

void statusLine(std::string_view bytes) {
  refusesInOneLine([&] { game::statusOf(std::string(bytes)); });
}

std::vector<std::string> jsonSeeds() {
  return {R"({"a": [1, 2.5, -1e300], "b": {"c": "\u00e9\n"}, "d": null, "e": true})", "[[[[[[[[1]]]]]]]]",
          R"({"a": 1, "a": 2})", "1e999", "\"\xff\""};
}
std::vector<std::string> statusLineSeeds() {
  return {"status 12.34 robot 1.0 -2.0 90 ball 3 4 going to kick", "status 1 robot ", "walking"};
}

const Registered jsonTarget({"json", json, jsonSeeds, 20000});
const Registered statusLineTarget({"statusLine", statusLine, statusLineSeeds, 20000});

}  // namespace
}  // namespace plumbline::fuzz
