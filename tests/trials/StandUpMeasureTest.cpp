#include "trials/StandUpMeasure.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(StandUpMeasure, theCostIsTheThesisFormula) {
  const TaskOutcome usual = standUpOutcome({}, 700, 12.5, true);
  EXPECT_NEAR(usual.cost, 12.5 + 0.08 * 700, 1e-12);
  const std::vector<std::pair<std::string, double>> figures = {{"time", 700}, {"error", 12.5}, {"up", 1}};
  EXPECT_EQ(usual.figures, figures);
  StandUpOptions options;
  options.weight = 0.03;
  EXPECT_NEAR(standUpOutcome(options, 700, 150, false).cost, 150 + 0.03 * 700, 1e-12);
}

}  // namespace
}  // namespace plumbline
