#include "framework/NearestName.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(NearestNameTest, editDistanceCountsChanges) {
  EXPECT_EQ(editDistance("", ""), 0u);
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("abc", "abc"), 0u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("noize", "noise"), 1u);
  EXPECT_EQ(editDistance("Alhpa", "Alpha"), 1u);      // neighbours swapped
  EXPECT_EQ(editDistance("ballpos", "BallPos"), 1u);  // two letters of another case
}

TEST(NearestNameTest, nearestIsTheFirstOfTheBestThatIsNearEnough) {
  EXPECT_EQ(nearestName("BallPoss", {"BallPercept", "BallPos", "RobotPose"}), "BallPos");
  EXPECT_EQ(nearestName("ab", {"ac", "ad"}), "ac");
  EXPECT_EQ(nearestName("Nonsense", {"BallPos"}), "");
  EXPECT_EQ(nearestName("x", {"y"}), "");  // nothing in common
  EXPECT_EQ(nearestName("a", {}), "");
}

TEST(NearestNameTest, suggestionIsTheEndOfAnErrorText) {
  EXPECT_EQ(suggestion("noize", {"noise"}), "; did you mean \"noise\"?");
  EXPECT_EQ(suggestion("noize", {"other"}), "");
}

}  // namespace
}  // namespace plumbline
