#include "modules/optimization/AgentTask.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/Thrown.h"
#include "trials/KickOptions.h"
#include "trials/StandUpOptions.h"

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

/// The options that it refuses, if it takes all others.
template <typename Options>
std::vector<std::string> refusedOptions(const std::string& task) {
  Options options;
  const auto& heeded = AgentTask::heeded(task);
  std::vector<std::string> refused;
  Options::parameterList().visit(
      &options, [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
        const std::string name = optionName(path);
        if (name == "direction" && parameter.words.size() == 3) return;  // front, back or side: below
        const std::string error = errorOf(task, {{name, otherValue(parameter, value)}});
        if (std::ranges::find(heeded, name) != heeded.end()) {
          EXPECT_EQ(error, "nothing thrown") << name;
          return;
        }
        refused.push_back(name);
        EXPECT_EQ(error, "the server's task " + task + " has the option " + name +
                             "; an agent cannot try that, bin/optworker can");
      });
  return refused;
}

TEST(AgentTask, anOptionThatItDoesNotHeedIsRefused) {
  // What is in the simulator alone; an option that is new has to be heeded, too.
  EXPECT_EQ(refusedOptions<KickOptions>("kick"),
            (std::vector<std::string>{"engine", "effects", "draws", "firstDraw"}));
  EXPECT_EQ(refusedOptions<StandUpOptions>("standUp"),
            (std::vector<std::string>{"start", "engine", "effects", "draws", "firstDraw"}));
}

TEST(AgentTask, standsUpFromFrontAndBackAlone) {
  EXPECT_EQ(errorOf("standUp", {{"direction", "back"}}), "nothing thrown");
  EXPECT_EQ(
      errorOf("standUp", {{"direction", "side"}}),
      "the server's task standUp has the option direction with the value side; an agent cannot try that, "
      "bin/optworker can");
}

TEST(AgentTask, anOptionThatIsGivenWithItsDefaultIsNoReason) {
  EXPECT_EQ(errorOf("kick", {{"engine", "ode"}, {"draws", "0"}}), "nothing thrown");
}

TEST(AgentTask, mistakesAreSaidAsTheTaskSaysThem) {
  EXPECT_EQ(errorOf("kick", {{"direction", "left"}}),
            "the server's task kick: option direction: \"left\" is no number from -180 to 180");
  EXPECT_EQ(errorOf("kick", {{"directoin", "30"}}),
            "the server's task kick: unknown option \"directoin\"; did you mean \"direction\"?");
  EXPECT_EQ(errorOf("dive", {}), "the server's task is dive; an agent can try the tasks kick and standUp");
}

}  // namespace
}  // namespace plumbline
