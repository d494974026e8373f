#include "trials/TaskOptions.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

struct TriedWorld {
  PARAMETERS(TriedWorld)
  PARAMETER(std::string, engine, "ode", "", Range(), "engine")
};

struct TriedOptions {
  PARAMETERS(TriedOptions)
  PARAMETER(double, height, 0.5, "m", Range(0, 2), "height")
  PARAMETER(int, times, 3, "", Range(1, 9), "times")
  PARAMETER_CHOICE(side, "left", "side", "left", "right")
  PARAMETER_GROUP(TriedWorld, world, "world")
};

TriedOptions read(std::map<std::string, std::string> values) {
  return TaskOptions(std::move(values)).as<TriedOptions>();
}

std::string errorOf(std::map<std::string, std::string> values) {
  try {
    read(std::move(values));
    return "no error";
  } catch (const ConfigurationError& error) {
    return error.what();
  }
}

TEST(TaskOptions, whatIsNotNamedKeepsItsDefault) {
  const TriedOptions options = read({{"height", "1.25"}});
  EXPECT_EQ(options.height, 1.25);
  EXPECT_EQ(options.times, 3);
  EXPECT_EQ(options.side, "left");
}

TEST(TaskOptions, anOptionOfAGroupIsNamedWithoutTheGroup) {
  EXPECT_EQ(read({{"engine", "bullet"}, {"times", "9"}, {"side", "right"}}).world.engine, "bullet");
  EXPECT_EQ(errorOf({{"world.engine", "bullet"}}), "unknown option \"world.engine\"");
}

TEST(TaskOptions, mistakesAreNamed) {
  EXPECT_EQ(errorOf({{"height", "3"}}), "option height: \"3\" is no number from 0 to 2");
  EXPECT_EQ(errorOf({{"height", "1 m"}}), "option height: \"1 m\" is no number from 0 to 2");
  EXPECT_EQ(errorOf({{"height", "nan"}}), "option height: \"nan\" is no number from 0 to 2");
  EXPECT_EQ(errorOf({{"times", "2.5"}}), "option times: \"2.5\" is no whole number from 1 to 9");
  EXPECT_EQ(errorOf({{"side", "middle"}}), "option side: \"middle\" is not one of left, right");
  EXPECT_EQ(errorOf({{"heigth", "1"}}), "unknown option \"heigth\"; did you mean \"height\"?");
}

TEST(TaskOptions, whatWasChangedIsNamed) {
  TriedOptions options = read({{"height", "0.5"}, {"times", "9"}, {"engine", "bullet"}});
  EXPECT_EQ(changedOptions(TriedOptions::parameterList(), &options),
            (std::vector<std::string>{"times", "engine"}));
}

TEST(TaskOptions, linesKeepThem) {
  const std::map<std::string, std::string> values{{"effects", "a=b.yaml"}, {"motion", ""}, {"type", "3"}};
  const TaskOptions options(values);
  EXPECT_EQ(options.lines(), (std::vector<std::string>{"effects=a=b.yaml", "motion=", "type=3"}));
  EXPECT_EQ(TaskOptions::ofLines(options.lines()).values(), values);
}

TEST(TaskOptions, theTypeOfARobotIsANumber) {
  EXPECT_EQ(TaskOptions().robotType(), 0);
  EXPECT_EQ(TaskOptions(std::map<std::string, std::string>{{"type", "3"}}).robotType(), 3);
  EXPECT_EQ(TaskOptions(std::map<std::string, std::string>{{"type", "all"}}).robotType(), 0);
}

}  // namespace
}  // namespace plumbline
