#include "framework/ProgressReport.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(ProgressReport, speaksWithoutATerminal) {
  testing::internal::CaptureStderr();
  {
    ProgressReport report("prog", ProgressReport::Seconds(0.01), ProgressReport::Seconds(0.01));
    report.update("searching", 0.25);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.substr(0, text.find('\n')), "prog: searching: 25 %");
}

TEST(ProgressReport, saysHowLongIsLeft) {
  testing::internal::CaptureStderr();
  {
    ProgressReport report("prog", ProgressReport::Seconds(0.02), ProgressReport::Seconds(100));
    report.update("searching", 0);
    report.update("searching", 0.5);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "prog: searching: 50 %, about 0 s left\n");
}

TEST(ProgressReport, staysSilentInShortWork) {
  testing::internal::CaptureStderr();
  { ProgressReport("prog").update("searching"); }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ProgressReport, durationsInWords) {
  EXPECT_EQ(durationText(40), "40 s");
  EXPECT_EQ(durationText(600), "10 min");
  EXPECT_EQ(durationText(3 * 3600 + 1800), "3.5 h");
}

}  // namespace
}  // namespace plumbline
