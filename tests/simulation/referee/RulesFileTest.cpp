#include "simulation/referee/RulesFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "framework/Config.h"
#include "framework/ConfigFile.h"
#include "simulation/referee/rules/Crowding.h"
#include "simulation/referee/rules/Incapable.h"

namespace plumbline::simulation {
namespace {

class RulesFile : public testing::Test {
protected:
  std::string file(const std::string& text) {
    std::ofstream(path) << text;
    return path;
  }
  std::string errorOf(const std::string& text) {
    try {
      readRules(file(text));
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  }
  const std::string path = testing::TempDir() + "rules-of-a-test.yaml";
  void TearDown() override { std::filesystem::remove(path); }
};

TEST_F(RulesFile, theProjectsOneSaysWhatHoldsWithoutIt) {
  EXPECT_EQ(readRules("doc/reference/rules.yaml"), Rules{});
  Rules strange;
  strange.time.half = 1;
  strange.of<simulation::Crowding>().on = strange.types.on = true;
  strange.pass.duration = 9;
  strange.moves.attempts = 3;
  EXPECT_EQ(readRules("doc/reference/rules.yaml", strange), Rules{}) << "and names everything";
}

TEST_F(RulesFile, whatIsWrittenIsRead) {
  Rules strange;
  strange.time.half = 60;
  strange.of<simulation::Incapable>().onGround = 7.5;
  EXPECT_EQ(readRules(file(rulesText(strange))), strange);
}

TEST_F(RulesFile, changesWhatItNames) {
  Rules expected;
  expected.time.half = 60;
  expected.of<simulation::Incapable>().on = false;
  expected.kickOff.after = 2;
  EXPECT_EQ(readRules(file("time: {half: 60}\nincapable: {on: false}\nkickOff: {after: 2}\n")), expected);
}

TEST_F(RulesFile, errorsNameLineAndKey) {
  EXPECT_EQ(errorOf("time:\n  half: -1\n"), path + ":2: time.half must be within [0.02, 1e+06], not -1");
  EXPECT_EQ(errorOf("touching:\n  on: maybe\n"),
            path + ":2: touching.on must be true or false, not \"maybe\"");
  EXPECT_EQ(errorOf("goals:\n  onn: true\n"), path + ":2: unknown key \"goals.onn\"; did you mean \"on\"?");
  EXPECT_EQ(errorOf("goal:\n  on: true\n"), path + ":1: unknown key \"goal\"; did you mean \"goals\"?");
  EXPECT_EQ(errorOf("goals: true\n"), path + ":1: goals must be a map, not \"true\"");
}

}  // namespace
}  // namespace plumbline::simulation
