#include "training/FirstSteps.h"

#include <gtest/gtest.h>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::training {
namespace {

std::vector<FirstStep> stepsOf(const std::string& text) {
  const test::ScratchFolder folder;
  folder.write("steps.yaml", text);
  return firstStepsIn(ConfigFile(folder / "steps.yaml").root());
}

TEST(FirstSteps, pathsAreThoseOfTheFileInItsOrder) {
  const std::vector<FirstStep> steps = stepsOf("walk: {maxTurn: 0.3, far: {gain: 2}}\nbias: 0.1\n");
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].path, "walk.maxTurn");
  EXPECT_EQ(steps[1].path, "walk.far.gain");
  EXPECT_EQ(steps[1].size, 2);
  EXPECT_EQ(steps[2].path, "bias");
  EXPECT_TRUE(steps[2].place.ends_with("steps.yaml:2: bias")) << steps[2].place;
}

TEST(FirstSteps, aStepIsANumberAboveZero) {
  EXPECT_THROW(stepsOf("walk: {maxTurn: 0}\n"), ConfigurationError);
  EXPECT_THROW(stepsOf("walk: {maxTurn: far}\n"), ConfigurationError);
  EXPECT_THROW(stepsOf("walk: [1, 2]\n"), ConfigurationError);
}

TEST(FirstSteps, aKeyMustBeThere) {
  EXPECT_TRUE(firstSteps("walk.turn.corner").empty());
  EXPECT_NE(thrownBy([] { firstSteps("walk.trun.corner"); }).find("search_steps.yaml"), std::string::npos)
      << thrownBy([] { firstSteps("walk.trun.corner"); });
}

TEST(FirstSteps, theNearestNameOfAPathIsSaid) {
  EXPECT_NO_THROW(checkPaths({{"a.b", 1, ""}}, {"a.b"}));
  EXPECT_EQ(thrownBy([] {
              checkPaths({{"walk.maxTrun", 1, "f.yaml:1: walk.maxTrun"}}, {"walk.maxTurn", "bias"});
            }),
            "f.yaml:1: walk.maxTrun: no parameter \"walk.maxTrun\"; did you mean \"walk.maxTurn\"?");
}

}  // namespace
}  // namespace plumbline::training
