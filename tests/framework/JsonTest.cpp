#include "framework/Json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/Thrown.h"

namespace plumbline {
namespace {

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

std::string problem(const std::string& text, const JsonLimits& limits = {}) {
  return thrownBy([&] { (void)parseJson(text, limits); });
}

TEST(JsonTest, readsWhatIsWithinTheLimits) {
  EXPECT_EQ(parseJson(R"({"a": [1, {"b": "x"}]})")["a"][1]["b"], "x");
  EXPECT_EQ(problem(nested(16)), "nothing thrown");
}

TEST(JsonTest, refusesDeepNestingHoweverDeep) {
  EXPECT_EQ(problem(nested(17)), "is nested deeper than 16 levels");
  EXPECT_EQ(problem(std::string(300000, '[')), "is nested deeper than 16 levels");
  std::string objects;
  for (int i = 0; i < 1000; ++i) objects += R"({"a":)";
  EXPECT_EQ(problem(objects, {.depth = 4}), "is nested deeper than 4 levels");
}

TEST(JsonTest, refusesLongTextsTwinKeysAndHugeNumbers) {
  EXPECT_EQ(problem(std::string((1 << 20) + 1, ' ')), "is larger than 1 MB");
  EXPECT_EQ(problem(R"({"a": {"b": 1, "b": 2}})"), "key \"b\" occurs twice in one object");
  EXPECT_EQ(problem(R"({"a": {"b": 1}, "b": 2})"), "nothing thrown");
  EXPECT_EQ(problem("[1e999]"), "holds a number that is too large");
}

TEST(JsonTest, namesTheLineOfBrokenJson) {
  try {
    (void)parseJson("{\n\"a\": 1,\n}\n");
    FAIL();
  } catch (const JsonError& error) {
    EXPECT_STREQ(error.what(), "broken JSON");
    EXPECT_EQ(error.line, 3u);
  }
  EXPECT_EQ(problem(""), "broken JSON");
}

}  // namespace
}  // namespace plumbline
