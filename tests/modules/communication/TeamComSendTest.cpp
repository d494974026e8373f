#include "modules/communication/TeamComSend.h"

#include <gtest/gtest.h>

#include "modules/communication/code/BeliefCode.h"
#include "modules/communication/code/SaySlot.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

class TeamComSendTest : public testing::Test {
protected:
  TeamComSendTest() {
    player.team = "Plumbline";
    player.number = belief.number = 7;
    belief.pose = Pose2(3, -2, 1);
  }
  std::string said(double time) {
    frame.time = time;
    harness.cycle();
    return say.text;
  }
  test::ModuleHarness<TeamComSend> harness;
  FrameInfo& frame = harness.input<FrameInfo>();
  PlayerInfo& player = harness.input<PlayerInfo>();
  TeamBelief& belief = harness.input<TeamComDataOut>().belief;
  const SayMessage& say = harness.output<SayMessage>();
};

TEST_F(TeamComSendTest, everyNumberSpeaksOnceInElevenSlotsAndNeverTwoAtATime) {
  for (int cycle = 0; cycle < 220; ++cycle) {
    const std::string text = said(50 + 0.02 * cycle);
    const std::int64_t slot = SaySlot::at(50 + 0.02 * cycle);
    if (!text.empty()) {
      EXPECT_EQ(SaySlot::speaker(slot), 7);
    }
  }
  int words = 0;
  for (int cycle = 0; cycle < 220; ++cycle) words += said(60 + 0.02 * cycle).empty() ? 0 : 1;
  EXPECT_EQ(words, 10);  // 4.4 s
}

TEST_F(TeamComSendTest, keepsWhatItsMatesUnderstand) {
  double time = 10;
  while (said(time).empty()) time += 0.02;
  EXPECT_EQ(say.time, time);
  const auto understood = decodeBelief(say.text, "Plumbline", SaySlot::at(time));
  ASSERT_TRUE(understood);
  EXPECT_EQ(say.said.pose.position, understood->pose.position);
  EXPECT_NEAR(say.said.pose.x(), 3, 0.05);
}

TEST_F(TeamComSendTest, afterARestartItSpeaksInTheSameSlotAgain) {
  double time = 10;
  while (said(time).empty()) time += 0.02;
  EXPECT_EQ(said(time), "");
  frame.restarted = true;
  EXPECT_NE(said(time), "");
}

TEST_F(TeamComSendTest, withoutANumberItIsSilent) {
  player.number = 0;
  for (int i = 0; i < 60; ++i) EXPECT_EQ(said(1 + 0.02 * i), "");
}

}  // namespace
}  // namespace plumbline
