#include "gap/inference/LeftJson.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace plumbline::gap {
namespace {

/// A recording of so many joints, of which the first shows a gap.
RecordingLeft leftOf(std::size_t joints) {
  RecordingLeft left;
  left.folder = "runs/tuesday";
  left.before = 0.02, left.after = 0.01, left.floor = 0.001, left.hasFloor = true;
  for (std::size_t j = 0; j < joints; ++j) {
    SignalLeft signal;
    signal.signal = "pos.j" + std::to_string(j);
    signal.position = true;
    signal.before = j == 0 ? 0.02 : 0.001;
    signal.after = signal.floor = 0.001;
    signal.hasFloor = true;
    left.signals.push_back(signal);
  }
  return left;
}

std::size_t linesOf(std::size_t joints) {
  const std::string text = leftTable({leftOf(joints)});
  return static_cast<std::size_t>(std::ranges::count(text, '\n')) - 2;  // without head and foot
}

TEST(LeftTable, ofFewJointsAllAreListedAndOfManyThoseWithAGap) {
  EXPECT_EQ(linesOf(1), 1U) << "what stands for all already";
  EXPECT_EQ(linesOf(2), 3U);
  EXPECT_EQ(linesOf(3), 4U);
  EXPECT_EQ(linesOf(4), 2U);
}

TEST(LeftTable, aLineHasThousandthsAndWhatIsClosedAboveTheFloor) {
  EXPECT_NE(
      leftTable({leftOf(1)})
          .find(
              "  runs/tuesday                           positions           20.0    10.0     1.0    53 %\n"),
      std::string::npos)
      << leftTable({leftOf(1)});
  RecordingLeft noisy = leftOf(1);
  noisy.noise = 0.002;
  EXPECT_NE(leftTable({noisy}).find("    ~2.0    56 %\n"), std::string::npos) << leftTable({noisy});
}

TEST(LeftTable, theEndOfALongNameIsShown) {
  RecordingLeft left = leftOf(1);
  left.folder = "a/very/long/way/to/where/the/recordings/are/tuesday";
  EXPECT_NE(leftTable({left}).find("  ...to/where/the/recordings/are/tuesday positions"), std::string::npos)
      << leftTable({left});
}

TEST(CheckJson, meansOverRecordingsAreOfSquares) {
  RecordingLeft one = leftOf(1), two = leftOf(1);
  one.before = 0.03, two.before = 0.04;
  const nlohmann::json j = checkJson({one, two});
  EXPECT_EQ(j["runs"].size(), 2U);
  EXPECT_DOUBLE_EQ(j["before"], 0.0353553);
  EXPECT_DOUBLE_EQ(j["after"], 0.01);
}

}  // namespace
}  // namespace plumbline::gap
