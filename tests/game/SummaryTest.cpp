#include "game/Summary.h"

#include <gtest/gtest.h>

using namespace plumbline::game;

namespace {

TEST(Summary, withAGoal) {
  const Summary summary{true, 61.239999, 1, 62.3, 1.23456, 101.26, 199.94};
  EXPECT_EQ(toJson(summary),
            "{\n  \"goal\": true,\n  \"goal_time_s\": 61.24,\n  \"falls\": 1,\n  \"sim_time_s\": 62.3,\n"
            "  \"wall_s\": 1.235,\n  \"agent_cpu_us_per_cycle\": 101.3,\n"
            "  \"simulator_cpu_us_per_cycle\": 199.9\n}\n");
}

TEST(Summary, withoutAGoalThereIsNoTimeOfIt) {
  EXPECT_NE(toJson({}).find("\"goal\": false,\n  \"goal_time_s\": null,"), std::string::npos);
}

}  // namespace
