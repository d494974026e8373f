#include "modules/evaluation/OutputProblems.h"

#include <gtest/gtest.h>

#include <vector>

#include "framework/ModuleObjects.h"

namespace plumbline {
namespace {

TEST(OutputProblems, areSaidAndKept) {
  std::vector<std::string> said;
  OutputProblems problems([&](const std::string& line) { said.push_back(line); });
  EXPECT_FALSE(problems.any());
  problems.add("the disk is full");
  problems.add("and another one");
  EXPECT_TRUE(problems.any());
  EXPECT_EQ(said, (std::vector<std::string>{"the disk is full", "and another one"}));
}

TEST(OutputProblems, everyAgentHasSome) {
  ModuleObjects objects;
  testing::internal::CaptureStderr();
  objects.find<OutputProblems>()->add("the disk is full");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "the disk is full\n");
  EXPECT_TRUE(objects.find<OutputProblems>()->any());
}

}  // namespace
}  // namespace plumbline
