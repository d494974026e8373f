#include "parameters/Parameter.h"

#include <gtest/gtest.h>

#include <limits>

using namespace plumbline;

namespace {

struct Gains {
  PARAMETERS(Gains)
  PARAMETER(double, position, 1.5, "1/s", Range(0, 10), "speed per metre", "feedback")
  PARAMETER(int, steps, 3, "", Range(1, 5), "number of steps")
};

struct Walk {
  PARAMETERS(Walk)
  PARAMETER(bool, enabled, true, "", Range(), "it walks")
  PARAMETER_GROUP(Gains, gains, "of the feedback")
  PARAMETER(std::vector<double>, x, (std::vector<double>{1, 0.25}), "m", Range(-1, 1), "places")
  PARAMETER_CHOICE(source, "feet", "of the odometry", "feet", "imu")
};

TEST(Parameter, isDeclaredOnceWithAllThatIsKnownOfIt) {
  std::vector<std::string> seen;
  Walk walk;
  Walk::parameterList().visit(
      &walk, [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
        seen.push_back(path + "|" + parameterType(value) + "|" + parameter.unit + "|" +
                       parameter.defaultText + "|" + parameterText(value) + "|" + parameter.comment);
      });
  EXPECT_EQ(seen,
            (std::vector<std::string>{
                "enabled|bool||true|true|it walks", "gains.position|double|1/s|1.5|1.5|speed per metre",
                "gains.steps|int||3|3|number of steps", "x|list of numbers|m|[1, 0.25]|[1, 0.25]|places",
                "source|text||feet|feet|of the odometry"}));
  EXPECT_EQ(Walk::parameterList().paths(),
            (std::vector<std::string>{"enabled", "gains.position", "gains.steps", "x", "source"}));
}

TEST(Parameter, isAnOrdinaryMember) {
  Walk one, other;
  one.gains.position = 2;
  EXPECT_EQ(other.gains.position, 1.5);
  const Gains gains{.position = 4, .steps = 1};
  EXPECT_EQ(gains.position, 4);
}

TEST(Parameter, isFoundByItsAttributes) {
  std::vector<std::string> feedback;
  Walk walk;
  Walk::parameterList().visit(
      &walk, [&](const std::string& path, const Parameter& parameter, const ParameterPointer&) {
        if (parameter.has("feedback")) feedback.push_back(path);
      });
  EXPECT_EQ(feedback, std::vector<std::string>{"gains.position"});
}

std::string faultOf(const std::string& wanted, Walk walk) {
  std::string fault = "no such parameter";
  Walk::parameterList().visit(
      &walk, [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
        if (path == wanted) fault = parameterFault(parameter, value);
      });
  return fault;
}

TEST(Parameter, saysWhatIsWrongWithAValue) {
  Walk walk;
  EXPECT_EQ(faultOf("gains.position", walk), "");
  walk.gains.position = 11;
  EXPECT_EQ(faultOf("gains.position", walk), "must be within [0, 10], not 11");
  walk.gains.position = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faultOf("gains.position", walk), "must be a finite number");
  walk.x = {0, -2};
  EXPECT_EQ(faultOf("x", walk), "must be within [-1, 1], not -2");
  walk.source = "camera";
  EXPECT_EQ(faultOf("source", walk), "must be feet or imu, not \"camera\"");
}

TEST(Parameter, keepsAllDigits) {
  double value = 0.1 + 0.2;
  EXPECT_EQ(std::stod(parameterText(&value)), value);
  float half = 0.1F;
  EXPECT_EQ(parameterText(&half), "0.1");
  std::vector<std::string> words{"a", "b \"c\""};
  EXPECT_EQ(parameterText(&words), R"(["a", "b \"c\""])");
}

TEST(Parameter, valueIsCopiedAndPutBack) {
  std::vector<double> x{1, 2};
  const ParameterPointer pointer = &x;
  const ParameterValue before = parameterValue(pointer);
  x.clear();
  setParameterValue(pointer, before);
  EXPECT_EQ(x, (std::vector<double>{1, 2}));
}

}  // namespace
