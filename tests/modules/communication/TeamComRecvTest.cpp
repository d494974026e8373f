// What one player says, another one understands; and what it does not believe.
#include <gtest/gtest.h>

#include "modules/communication/TeamComRecv.h"
#include "modules/communication/TeamComSend.h"
#include "modules/communication/code/SaySlot.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

struct TeamComTest : testing::Test {
  TeamComTest() {
    sender.input<PlayerInfo>().team = receiver.input<PlayerInfo>().team = "Plumbline";
    sender.input<PlayerInfo>().number = 7;
    receiver.input<PlayerInfo>().number = 2;
    sender.input<TeamComDataOut>().belief.number = 7;
    sender.input<TeamComDataOut>().belief.pose = Pose2(3, -2, 1);
  }
  std::string said(double time) {
    sender.input<FrameInfo>().time = time;
    sender.cycle();
    return sender.output<SayMessage>().text;
  }
  std::size_t believed(const std::string& text, double time, const std::string& team = "Plumbline") {
    receiver.input<FrameInfo>().time = time;
    HeardText heard;
    heard.team = team;
    heard.text = text;
    receiver.input<HearPercept>().messages = {heard};
    receiver.cycle();
    return receiver.output<TeamComDataIn>().beliefs.size();
  }
  /// The first time from then on at which number 7 speaks, and its words.
  std::pair<double, std::string> nextWords(double from) {
    for (int i = 0; i < 30; ++i)
      if (const std::string text = said(from + 0.02 * i); !text.empty()) return {from + 0.02 * i, text};
    return {};
  }
  test::ModuleHarness<TeamComSend> sender;
  test::ModuleHarness<TeamComRecv> receiver;
};

TEST_F(TeamComTest, everyNumberSpeaksOnceInElevenSlotsAndNeverTwoAtATime) {
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

TEST_F(TeamComTest, isUnderstoodACycleLater) {
  const auto [time, text] = nextWords(10);
  ASSERT_EQ(believed(text, time + 0.02), 1u);
  const TeamBelief& belief = receiver.output<TeamComDataIn>().beliefs[0];
  EXPECT_EQ(belief.number, 7);
  EXPECT_NEAR(belief.pose.x(), 3, 0.05);
  EXPECT_EQ(belief.pose.position, sender.output<SayMessage>().said.pose.position);
}

TEST_F(TeamComTest, whatAnotherTeamSaysIsNotBelieved) {
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02, "Others"), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().heard, 0u);
}

TEST_F(TeamComTest, ourOwnWordsRepeatedLaterAreNotBelieved) {
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02, ""), 1u);  // servers that name no team
  EXPECT_EQ(believed(text, time + 0.3), 0u);
  EXPECT_EQ(believed(text, time + 0.44), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().refused, 2u);
}

TEST_F(TeamComTest, aSecondPlayerWithTheOwnNumberIsNotHeard) {
  receiver.input<PlayerInfo>().number = 7;
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02), 0u);
}

TEST_F(TeamComTest, nonsenseIsRefusedAndCounted) {
  for (const std::string& text : {std::string(), std::string("x"), std::string(20, 'A'),
                                  std::string(5000, 'A'), std::string("\0\xff()\"\n", 6)})
    EXPECT_EQ(believed(text, 3), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().refused, 5u);
}

TEST_F(TeamComTest, withoutANumberItIsSilent) {
  sender.input<PlayerInfo>().number = 0;
  for (int i = 0; i < 60; ++i) EXPECT_EQ(said(1 + 0.02 * i), "");
}

}  // namespace
