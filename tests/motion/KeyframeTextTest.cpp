#include "motion/KeyframeText.h"

#include <gtest/gtest.h>

#include "motion/KeyframeReader.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::motion {
namespace {

const std::string wave =
    "# Wave with the left arm.\n"
    "rest: stays\n"
    "keyframes:\n"
    "  # up\n"
    "  - {time: 0.50, LShoulderPitch: -80, LShoulderRoll: 20}  # both joints\n"
    "  # out\n"
    "  - {time: 0.2, settle: 0.5, LElbowRoll: -60}\n"
    "  - {time: 0.5,\n"
    "     ShoulderPitch: 90.0, ShoulderRoll: 14}\n"
    "# the end\n";

std::vector<KeyframeDraft> drafts(const std::string& text) {
  return draftOf(readKeyframeText(text, "wave.yaml", simsparkRobot(0), {}), simsparkRobot(0));
}

std::string errorOf(const std::string& text, const std::vector<KeyframeDraft>& keyframes) {
  try {
    return editedText(text, "wave.yaml", keyframes, simsparkRobot(0));
  } catch (const KeyframeFileError& error) {
    return error.what();
  }
}

TEST(KeyframeTextTest, aDraftHoldsEveryJointInDegrees) {
  const auto keyframes = drafts(wave);
  ASSERT_EQ(keyframes.size(), 3u);
  EXPECT_EQ(keyframes[1].from, 1);
  EXPECT_EQ(keyframes[1].settleSeconds, 0.5);
  EXPECT_EQ(keyframes[1].degrees, (std::map<std::string, double>{{"LElbowRoll", -60}}));
  EXPECT_EQ(
      keyframes[2].degrees,
      (std::map<std::string, double>{
          {"LShoulderPitch", 90}, {"RShoulderPitch", 90}, {"LShoulderRoll", 14}, {"RShoulderRoll", -14}}));
}

TEST(KeyframeTextTest, whatStaysKeepsEveryByte) {
  EXPECT_EQ(editedText(wave, "wave.yaml", drafts(wave), simsparkRobot(0)), wave);
}

TEST(KeyframeTextTest, aNumberIsReplacedInItsPlace) {
  auto keyframes = drafts(wave);
  keyframes[0].seconds = 0.4;
  keyframes[0].degrees["LShoulderRoll"] = 21.5;
  const std::string text = editedText(wave, "wave.yaml", keyframes, simsparkRobot(0));
  EXPECT_NE(text.find("  - {time: 0.4, LShoulderPitch: -80, LShoulderRoll: 21.5}  # both joints\n"),
            std::string::npos)
      << text;
}

TEST(KeyframeTextTest, bothSidesStayUnderOneNameAsLongAsTheyAreMirrorImages) {
  auto keyframes = drafts(wave);
  keyframes[2].degrees["LShoulderPitch"] = 80;
  keyframes[2].degrees["RShoulderPitch"] = 80;
  EXPECT_NE(editedText(wave, "wave.yaml", keyframes, simsparkRobot(0))
                .find("     ShoulderPitch: 80, ShoulderRoll: 14}\n"),
            std::string::npos);
  keyframes[2].degrees["RShoulderPitch"] = 70;
  EXPECT_NE(editedText(wave, "wave.yaml", keyframes, simsparkRobot(0))
                .find("     LShoulderPitch: 80, RShoulderPitch: 70, ShoulderRoll: 14}\n"),
            std::string::npos);
}

TEST(KeyframeTextTest, jointsComeAndGo) {
  auto keyframes = drafts(wave);
  keyframes[0].degrees.erase("LShoulderRoll");
  keyframes[1].degrees["HeadYaw"] = 10;
  keyframes[1].settleSeconds = 0;
  const std::string text = editedText(wave, "wave.yaml", keyframes, simsparkRobot(0));
  EXPECT_NE(text.find("  - {time: 0.50, LShoulderPitch: -80}  # both joints\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  - {time: 0.2, LElbowRoll: -60, HeadYaw: 10}\n"), std::string::npos) << text;
}

TEST(KeyframeTextTest, keyframesMoveWithTheirComments) {
  auto keyframes = drafts(wave);
  std::swap(keyframes[0], keyframes[1]);
  keyframes.push_back({-1, 0.25, 0, {{"LKneePitch", 20}, {"RKneePitch", 20}}});
  keyframes.erase(keyframes.begin() + 2);
  EXPECT_EQ(editedText(wave, "wave.yaml", keyframes, simsparkRobot(0)),
            "# Wave with the left arm.\n"
            "rest: stays\n"
            "keyframes:\n"
            "  # out\n"
            "  - {time: 0.2, settle: 0.5, LElbowRoll: -60}\n"
            "  # up\n"
            "  - {time: 0.50, LShoulderPitch: -80, LShoulderRoll: 20}  # both joints\n"
            "  - {time: 0.25, KneePitch: 20}\n"
            "# the end\n");
}

TEST(KeyframeTextTest, aLineForEachKeyCanBeEditedToo) {
  const std::string text =
      "rest: stays\n"
      "keyframes:\n"
      "  - time: 0.2\n"
      "    LHipPitch: -30  # bent\n"
      "  - time: 0.1\n"
      "    HeadYaw: 10\n";
  auto keyframes = drafts(text);
  keyframes[0].degrees["LHipPitch"] = -20;
  EXPECT_NE(editedText(text, "wave.yaml", keyframes, simsparkRobot(0)).find("    LHipPitch: -20  # bent\n"),
            std::string::npos);
  keyframes[1].degrees["HeadPitch"] = 5;
  EXPECT_NE(editedText(text, "wave.yaml", keyframes, simsparkRobot(0))
                .find("  - {time: 0.1, HeadYaw: 10, HeadPitch: 5}\n"),
            std::string::npos);
}

TEST(KeyframeTextTest, whatCannotBeEditedSaysWhy) {
  EXPECT_EQ(errorOf("mirror: wave\n", {{0, 1, 0, {}}}),
            "wave.yaml:1: this is the mirror image of wave; edit that one");
  EXPECT_EQ(errorOf("rest: stays\nkeyframes: [{time: 1, HeadYaw: 0}]\n", {{0, 1, 0, {}}}),
            "wave.yaml:2: keyframes are in brackets; give each a line that begins with \"- \" to edit them");
  EXPECT_EQ(errorOf(wave, {{7, 1, 0, {}}}), "wave.yaml: there is no keyframe 7");
}

}  // namespace
}  // namespace plumbline::motion
