#include "gap/diagnosis/UnusedColumns.h"

#include <gtest/gtest.h>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

TEST(UnusedColumnsTest, aLineOfEachKindAndReason) {
  std::vector<Trial> trials{armTrial(twoJointArm(), 1), armTrial(twoJointArm(), 1)};
  trials[1].unused = {"temperature.* is not used: no model here predicts it"};
  const auto why = [](std::size_t t, std::size_t s) { return t == 1 && s == 1 ? "it is too short" : ""; };
  EXPECT_EQ(unusedColumns(trials, why),
            (std::vector<std::string>{"pos.* is not used: it is too short",
                                      "temperature.* is not used: no model here predicts it"}));
}

TEST(UnusedColumnsTest, blocksDoNotLookAtEfforts) {
  Trial trial = armTrial(twoJointArm(), 1);
  EXPECT_TRUE(unusedByBlocks({trial}).empty());
  trial.signals[0].kind = SignalKind::current;
  trial.signals[0].name = "current.shoulder";
  EXPECT_EQ(unusedByBlocks({trial}),
            std::vector<std::string>{
                "current.* is not used: --method blocks does not look at it; --method sets does"});
}

}  // namespace
}  // namespace plumbline::gap
