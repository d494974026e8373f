#include "modules/communication/TeamComRecv.h"

#include <gtest/gtest.h>

#include "modules/communication/TeamComSend.h"
#include "support/ModuleHarness.h"

using namespace plumbline;

namespace {

/// Number 2 hears what number 7 says.
struct TeamComRecvTest : testing::Test {
  TeamComRecvTest() {
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

TEST_F(TeamComRecvTest, isUnderstoodACycleLater) {
  const auto [time, text] = nextWords(10);
  ASSERT_EQ(believed(text, time + 0.02), 1u);
  const TeamBelief& belief = receiver.output<TeamComDataIn>().beliefs[0];
  EXPECT_EQ(belief.number, 7);
  EXPECT_NEAR(belief.pose.x(), 3, 0.05);
  EXPECT_EQ(belief.pose.position, sender.output<SayMessage>().said.pose.position);
}

TEST_F(TeamComRecvTest, whatAnotherTeamSaysIsNotBelieved) {
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02, "Others"), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().heard, 0u);
}

TEST_F(TeamComRecvTest, ourOwnWordsRepeatedLaterAreNotBelieved) {
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02, ""), 1u);  // servers that name no team
  EXPECT_EQ(believed(text, time + 0.3), 0u);
  EXPECT_EQ(believed(text, time + 0.44), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().refused, 2u);
}

TEST_F(TeamComRecvTest, aSecondPlayerWithTheOwnNumberIsNotHeard) {
  receiver.input<PlayerInfo>().number = 7;
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.02), 0u);
}

TEST_F(TeamComRecvTest, howOldAMessageMayBeIsAParameter) {
  const auto [time, text] = nextWords(10);
  EXPECT_EQ(believed(text, time + 0.2), 0u);
  receiver.module().oldestSlot = 5;
  EXPECT_EQ(believed(text, time + 0.2), 1u);
}

TEST_F(TeamComRecvTest, nonsenseIsRefusedAndCounted) {
  for (const std::string& text : {std::string(), std::string("x"), std::string(20, 'A'),
                                  std::string(5000, 'A'), std::string("\0\xff()\"\n", 6)})
    EXPECT_EQ(believed(text, 3), 0u);
  EXPECT_EQ(receiver.output<TeamComDataIn>().refused, 5u);
}

}  // namespace
