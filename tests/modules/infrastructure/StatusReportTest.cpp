#include "modules/infrastructure/StatusReport.h"

#include <gtest/gtest.h>

#include "representations/motion/KickMotionOutput.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/StandOutput.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/skills/SkillDribbleOutput.h"
#include "representations/skills/SkillKickOutput.h"
#include "representations/skills/SkillMoveToPosOutput.h"

namespace plumbline {
namespace {

TEST(StatusReport, saysWhatTheRobotDoes) {
  const SkillDribbleOutput dribble;
  const SkillKickOutput kick;
  const SkillMoveToPosOutput moveToPos;
  const WalkingEngineOutput walks;
  const StandOutput stands;
  const KickMotionOutput kicks;
  const SpecialActionsOutput keyframes;
  EXPECT_EQ(statusWords(&dribble, &walks, Posture::upright, false), "dribbling");
  EXPECT_EQ(statusWords(&kick, &walks, Posture::upright, false), "going to kick");
  EXPECT_EQ(statusWords(&kick, &kicks, Posture::upright, false), "kicking");
  EXPECT_EQ(statusWords(&moveToPos, &walks, Posture::upright, true), "searching");
  EXPECT_EQ(statusWords(&moveToPos, &stands, Posture::upright, true), "walking");
  EXPECT_EQ(statusWords(nullptr, &walks, Posture::upright, false), "walking");
  EXPECT_EQ(statusWords(nullptr, &stands, Posture::upright, false), "standing");
  EXPECT_EQ(statusWords(nullptr, nullptr, Posture::upright, false), "standing");
  EXPECT_EQ(statusWords(&kick, &keyframes, Posture::onBack, false), "getting up from the back");
  EXPECT_EQ(statusWords(&kick, &keyframes, Posture::upright, false), "getting up");
  EXPECT_EQ(statusWords(&kick, &walks, Posture::falling, false), "falling");
}

/// A motion and a skill that no file of the project names.
REPRESENTATION_OF(StatusBowOutput, MotionOutput)
class StatusBowOutput : public StatusBowOutputBase {
public:
  explicit StatusBowOutput(bool ends = false) : StatusBowOutputBase("bow", ends) {}
};

TEST(StatusReport, saysWhatANewMotionDoes) {
  const SkillMoveToPosOutput moveToPos;
  EXPECT_EQ(statusWords(nullptr, std::make_unique<StatusBowOutput>().get(), Posture::upright, true), "bow");
  EXPECT_EQ(statusWords(&moveToPos, std::make_unique<StatusBowOutput>(true).get(), Posture::upright, true),
            "bow");
}

}  // namespace
}  // namespace plumbline
