#include "tactics/FieldValue.h"

#include <gtest/gtest.h>

#include <fstream>

#include "framework/ConfigFile.h"
#include "support/Thrown.h"

using namespace plumbline;

namespace {

constexpr const char* small = R"(x: [-10, 10]
y: [0, 8]
theirs:
  - [-0.9, 0.1]
  - [-0.7, 0.0]
nobodys:
  - [-0.5, 0.5]
  - [-0.4, 0.4]
ours:
  - [-0.1, 0.9]
  - [0.0, 0.7]
)";

FieldValue valueOf(const std::string& text) {
  const std::string path = testing::TempDir() + "field_value.yaml";
  std::ofstream(path) << text;
  return FieldValue(ConfigFile(path).root());
}

TEST(FieldValueTest, interpolatesPlaceAndAdvantage) {
  const FieldValue value = valueOf(small);
  EXPECT_DOUBLE_EQ(value.at({{10, 0}, 0}), 0.5);
  EXPECT_DOUBLE_EQ(value.at({{0, 0}, 0}), 0);
  EXPECT_DOUBLE_EQ(value.at({{10, -4}, 1}), 0.8);
  EXPECT_DOUBLE_EQ(value.at({{10, 0}, 0.5}), 0.7);
}

TEST(FieldValueTest, isWrittenAsItIsRead) {
  const FieldValue value = valueOf(small);
  EXPECT_EQ(valueOf(value.yaml()).yaml(), value.yaml());
  EXPECT_EQ(value.yaml().substr(0, 24), "x: [-10, 10]\ny: [0, 8]\nt");
}

TEST(FieldValueTest, itsErrorsSayWhereAndWhat) {
  const std::string path = testing::TempDir() + "field_value.yaml:";
  const auto errorOf = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return thrownBy([&] { valueOf(text); });
  };
  EXPECT_EQ(errorOf(small, "[-10, 10]", "[-10, 12]"), path + "1: x must be symmetric about 0");
  EXPECT_EQ(errorOf(small, "[-10, 10]", "[10, -10]"), path + "1: x must rise from number to number");
  EXPECT_EQ(errorOf(small, "[0, 8]", "[1, 8]"),
            path + "2: y must begin with 0: the other side is its mirror image");
  EXPECT_EQ(errorOf(small, "  - [0.0, 0.7]\n", ""),
            path + "9: ours must have 2 rows, one for each y, of 2 numbers, one for each x");
}

TEST(FieldValueTest, theProjectsOwnRisesTowardsTheGoalAndWithTheBall) {
  const FieldValue value(ConfigFile("config/field_value.yaml").root());
  for (const double y : {0.0, 4.0, 8.0}) {
    EXPECT_GT(value.at({{12, y}, 0}), value.at({{0, y}, 0}) + 0.1) << y;
    EXPECT_LT(value.at({{-12, y}, 0}), value.at({{0, y}, 0}) - 0.1) << y;
    for (double x = -14; x <= 14; x += 2)
      EXPECT_GT(value.at({{x, y}, 1}), value.at({{x, y}, -1})) << x << " " << y;
  }
}

}  // namespace
