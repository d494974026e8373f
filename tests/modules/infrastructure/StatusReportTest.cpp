#include "modules/infrastructure/StatusReport.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

TEST(StatusReport, saysWhatTheRobotDoes) {
  EXPECT_EQ(statusWords("dribbling", Motion::walk, Posture::upright, false), "dribbling");
  EXPECT_EQ(statusWords("going to kick", Motion::walk, Posture::upright, false), "going to kick");
  EXPECT_EQ(statusWords("going to kick", Motion::kick, Posture::upright, false), "kicking");
  EXPECT_EQ(statusWords("walking", Motion::walk, Posture::upright, true), "searching");
  EXPECT_EQ(statusWords("", Motion::stand, Posture::upright, false), "standing");
  EXPECT_EQ(statusWords("going to kick", Motion::specialAction, Posture::onBack, false),
            "getting up from the back");
  EXPECT_EQ(statusWords("going to kick", Motion::specialAction, Posture::upright, false), "getting up");
  EXPECT_EQ(statusWords("going to kick", Motion::walk, Posture::falling, false), "falling");
}

}  // namespace
