#include "modules/optimization/AgentTask.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/Thrown.h"
#include "trials/KickOptions.h"

namespace plumbline {
namespace {

using Options = std::map<std::string, std::string>;

std::string errorOf(const std::string& task, const Options& options) {
  return thrownBy([&] { AgentTask::make(task, TaskOptions(options)); });
}

/// A value that the option may have and that is not the declared one.
std::string otherValue(const Parameter& parameter, const ParameterPointer& value) {
  if (std::get_if<std::string*>(&value)) return parameter.words.empty() ? "other" : parameter.words.back();
  double greatest = parameter.range.max;
  if (std::get_if<int*>(&value)) return std::to_string(static_cast<int>(greatest));
  return parameterText(&greatest);
}

TEST(AgentTask, anOptionThatItDoesNotHeedIsRefused) {
  KickOptions options;
  const auto& heeded = AgentTask::heeded("kick");
  std::vector<std::string> refused;
  KickOptions::parameterList().visit(
      &options, [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
        const std::string name = optionName(path);
        const std::string error = errorOf("kick", {{name, otherValue(parameter, value)}});
        if (std::ranges::find(heeded, name) != heeded.end()) {
          EXPECT_EQ(error, "nothing thrown") << name;
        } else {
          refused.push_back(name);
          EXPECT_EQ(error, "the server's task kick has the option " + name +
                               "; an agent cannot try that, bin/optworker can");
        }
      });
  EXPECT_EQ(refused, (std::vector<std::string>{"engine", "effects", "draws", "firstDraw"}))
      << "what is in the simulator alone; an option that is new has to be heeded, too";
}

TEST(AgentTask, anOptionThatIsGivenWithItsDefaultIsNoReason) {
  EXPECT_EQ(errorOf("kick", {{"engine", "ode"}, {"draws", "0"}}), "nothing thrown");
}

TEST(AgentTask, mistakesAreSaidAsTheTaskSaysThem) {
  EXPECT_EQ(errorOf("kick", {{"direction", "left"}}),
            "the server's task kick: option direction: \"left\" is no number from -180 to 180");
  EXPECT_EQ(errorOf("kick", {{"directoin", "30"}}),
            "the server's task kick: unknown option \"directoin\"; did you mean \"direction\"?");
  EXPECT_EQ(errorOf("dive", {}), "the server's task is dive; an agent can try kicks (task kick)");
}

}  // namespace
}  // namespace plumbline
