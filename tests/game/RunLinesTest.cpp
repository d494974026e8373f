#include "game/RunLines.h"

#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

TEST(RunLinesTest, aLineWaitsForWhatTheAgentSays) {
  RunLines lines;
  lines.add({1.0, "one"});
  EXPECT_EQ(lines.due(1.0, {}), "");
  EXPECT_EQ(lines.due(1.1, {{0.5, "standing"}}), "");
  // What was said later belongs to the next line.
  EXPECT_EQ(lines.due(1.2, {{0.5, "standing"}, {0.98, "kicking"}, {1.04, "walking"}}), "one kicking\n");
  EXPECT_EQ(lines.due(9, {}), "");
}

TEST(RunLinesTest, theOrderOfReadingDecidesNothing) {
  const std::vector<StatusWords> early = {{0.5, "standing"}}, late = {{0.5, "standing"}, {1.95, "walking"}};
  RunLines slow, fast;
  for (RunLines* lines : {&slow, &fast}) {
    lines->add({1.0, "one"});
    lines->add({2.0, "two"});
  }
  EXPECT_EQ(slow.due(1.5, early) + slow.rest(2.0, early), "one standing\ntwo standing\n");
  EXPECT_EQ(fast.due(1.5, late) + fast.rest(2.0, late), "one standing\ntwo standing\n");
}

TEST(RunLinesTest, goalsAndFalls) {
  RunLines lines;
  lines.add({1.0, "a", true, false});
  lines.add({2.0, "b", true, false});
  lines.add({3.0, "c", false, true});
  EXPECT_EQ(lines.rest(3.0, {{1.5, "getting up"}}), "a fallen\nb getting up\nc GOAL\n");
}

}  // namespace
}  // namespace plumbline::game
