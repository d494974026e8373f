#include "walking/parameters/WalkParameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace plumbline::walking {
namespace {

std::string faultOf(const WalkParameters& parameters) {
  try {
    parameters.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(WalkParameters, theFirstBadValueIsNamed) {
  WalkParameters parameters;
  EXPECT_EQ(faultOf(parameters), "");
  parameters.step.height = 0.5;
  EXPECT_EQ(faultOf(parameters), "walking parameter step.height must be within [0.001, 0.1], not 0.5");
  parameters.step.height = std::nan("");
  EXPECT_EQ(faultOf(parameters), "walking parameter step.height must be a finite number");
}

TEST(WalkParameters, theShortestStepIsNotLongerThanTheUsualOne) {
  WalkParameters parameters;
  parameters.step.minDuration = 0.19;
  EXPECT_EQ(faultOf(parameters), "walking parameter step.minDuration must be within [0, 0.18], not 0.19");
}

TEST(WalkParameters, everyMemberHasItsPath) {
  std::set<const double*> places;
  WalkParameters parameters;
  for (const WalkParameter& one : walkParameters()) places.insert(&one.of(parameters));
  EXPECT_EQ(places.size() * sizeof(double), sizeof(WalkParameters));
  EXPECT_EQ(&walkParameter("step.duration").of(parameters), &parameters.step.duration);
  EXPECT_EQ(findWalkParameter("step"), nullptr);
  EXPECT_THROW(walkParameter("stepDuration"), std::invalid_argument);
}

TEST(WalkParameters, everyParameterSaysWhatItIs) {
  for (const WalkParameter& one : walkParameters()) {
    EXPECT_FALSE(one.declared->comment.empty()) << one.path;
    EXPECT_TRUE(std::isfinite(one.declared->range.min) && std::isfinite(one.declared->range.max)) << one.path;
  }
}

}  // namespace
}  // namespace plumbline::walking
