#include "simulation/sensors/Hearing.h"

#include <gtest/gtest.h>

namespace plumbline::simulation {
namespace {

TEST(Hearing, ownWordsAlwaysAndFirst) {
  Hearing ears;
  for (int i = 0; i < 3; ++i) {
    ears.hear("enemy", "B", 1, false);
    ears.hearSelf("me" + std::to_string(i));
    const auto heard = ears.collect("A", 2.5);
    ASSERT_GE(heard.size(), 1u);
    EXPECT_TRUE(heard[0].self);
    EXPECT_EQ(heard[0].text, "me" + std::to_string(i));
    EXPECT_EQ(heard[0].team, "A");
    EXPECT_EQ(heard[0].time, 2.5);
  }
  EXPECT_TRUE(ears.collect("A", 3).empty()) << "words are heard once";
}

TEST(Hearing, oneMessageInTwoCyclesFromEachTeam) {
  Hearing ears;
  std::string mates, opponents;
  for (int cycle = 0; cycle < 6; ++cycle) {
    for (const char* text : {"a", "b"}) {
      ears.hear(text, "A", 0.5, true);
      ears.hear(text, "B", -0.5, false);
    }
    for (const auto& heard : ears.collect("A", 0)) {
      (heard.team == "A" ? mates : opponents) += heard.text;
      EXPECT_EQ(heard.direction, heard.team == "A" ? 0.5 : -0.5);
    }
    mates += '.';
    opponents += '.';
  }
  EXPECT_EQ(mates, "a..a..a..") << "the first of a cycle, then a pause";
  EXPECT_EQ(opponents, mates);
}

}  // namespace
}  // namespace plumbline::simulation
