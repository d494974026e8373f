#include "situation/kinds/SkillExpected.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(SkillExpectedTest, wordsAreASkillAndAPlace) {
  SkillExpected e;
  e.skill = "kick";
  e.target = Vec2(1, 2);
  e.within = 0.3;
  EXPECT_EQ(e.words(0), "kicks to (1, 2) within 0.3 m");
  SkillExpected stands;
  stands.skill = "stand";
  EXPECT_EQ(stands.words(0), "stands");
}

}  // namespace
}  // namespace plumbline
