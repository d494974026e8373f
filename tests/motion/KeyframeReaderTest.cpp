#include "motion/KeyframeReader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::motion {
namespace {

namespace fs = std::filesystem;

class KeyframeReaderTest : public testing::Test {
protected:
  KeyframeReaderTest() {
    directory = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(directory);
    fs::create_directories(directory / "type");
    directories = {directory, directory / "type"};
  }
  ~KeyframeReaderTest() override { fs::remove_all(directory); }

  void write(const std::string& name, const std::string& text) { std::ofstream(directory / name) << text; }
  KeyframeMotion read(const std::string& text, int type = 0) {
    write("m.yaml", text);
    return readKeyframeFile(directory / "m.yaml", simsparkRobot(type), directories);
  }
  /// The message without the directory in front.
  std::string errorOf(const std::string& text, int type = 0) {
    try {
      read(text, type);
    } catch (const KeyframeFileError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind(directory.string() + "/", 0), 0u) << what;
      return what.substr(directory.string().size() + 1);
    }
    return "no error";
  }

  fs::path directory;
  std::vector<fs::path> directories;
};

TEST_F(KeyframeReaderTest, readsDegreesAndBothSides) {
  const KeyframeMotion motion = read(
      "rest: stays\n"
      "keyframes:\n"
      "  - time: 0.2\n"
      "    LHipPitch: -30\n"
      "    HipRoll: 20\n"
      "    KneePitch: 90\n"
      "  - {time: 0.1, settle: 0.5, HeadYaw: 10}\n");
  EXPECT_EQ(motion.name, "m");
  ASSERT_EQ(motion.keyframes.size(), 2u);
  const Keyframe& first = motion.keyframes[0];
  EXPECT_DOUBLE_EQ(first.seconds, 0.2);
  EXPECT_DOUBLE_EQ(first.angles[lHipPitch], fromDegrees(-30));
  EXPECT_TRUE(first.set[lHipPitch]);
  EXPECT_FALSE(first.set[rHipPitch]);
  EXPECT_DOUBLE_EQ(first.angles[lHipRoll], fromDegrees(20));
  EXPECT_DOUBLE_EQ(first.angles[rHipRoll], fromDegrees(-20));
  EXPECT_DOUBLE_EQ(first.angles[rKneePitch], fromDegrees(90));
  EXPECT_DOUBLE_EQ(motion.keyframes[1].settleSeconds, 0.5);
  EXPECT_TRUE(motion.keyframes[1].set[headYaw]);
}

TEST_F(KeyframeReaderTest, readsAKickAndItsMirrorImage) {
  write("right.yaml",
        "ball: [0.2, -0.06]\n"
        "ballReach: [0.02, 0.02]\n"
        "kick: {distance: 9.5, direction: 4, contact: 0.25}\n"
        "keyframes:\n"
        "  - {time: 0.1, RHipRoll: -5, ballY: {RHipRoll: 100}, ballX: {RHipRoll: 50}}\n");
  const KeyframeMotion motion = read("mirror: right\n");
  EXPECT_EQ(motion.name, "m");
  EXPECT_DOUBLE_EQ(motion.ball.y(), 0.06);
  ASSERT_TRUE(motion.kick);
  EXPECT_DOUBLE_EQ(motion.kick->distance, 9.5);
  EXPECT_DOUBLE_EQ(motion.kick->direction, fromDegrees(-4));
  EXPECT_DOUBLE_EQ(motion.kick->contact, 0.25);
  EXPECT_DOUBLE_EQ(motion.keyframes[0].angles[lHipRoll], fromDegrees(5));
  ASSERT_EQ(motion.keyframes[0].ballGains.size(), 1u);
  EXPECT_EQ(motion.keyframes[0].ballGains[0].joint, lHipRoll);
  EXPECT_DOUBLE_EQ(motion.keyframes[0].ballGains[0].gain.x(), fromDegrees(-50));
  EXPECT_DOUBLE_EQ(motion.keyframes[0].ballGains[0].gain.y(), fromDegrees(100));
}

TEST_F(KeyframeReaderTest, readsHowAKickScattersInGames) {
  const KeyframeMotion motion = read(
      "ball: [0.2, -0.06]\nballReach: [0.02, 0.02]\n"
      "kick: {distance: 9, scatter: 4.5, spread: 1.2, rise: 0.6}\nkeyframes: [{time: 1, HeadYaw: 1}]\n");
  ASSERT_TRUE(motion.kick);
  EXPECT_DOUBLE_EQ(motion.kick->scatter, fromDegrees(4.5));
  EXPECT_DOUBLE_EQ(motion.kick->spread, 1.2);
  EXPECT_DOUBLE_EQ(motion.kick->rise, 0.6);
}

TEST_F(KeyframeReaderTest, theTypesOwnFileWins) {
  write("a.yaml", "keyframes: [{time: 1, HeadYaw: 1}]\n");
  write("b.yaml", "keyframes: [{time: 2, HeadYaw: 1}]\n");
  write("c.yaml", "mirror: b\n");
  write("type/b.yaml", "keyframes: [{time: 3, HeadYaw: 1}]\n");
  write("notes.txt", "not a motion");
  const auto motions = readMotions(directories, simsparkRobot(0));
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].name, "a");
  EXPECT_DOUBLE_EQ(motions[1].seconds(), 3);
  EXPECT_DOUBLE_EQ(motions[2].seconds(), 3) << "the mirror image is of the type's own motion, too";
  EXPECT_EQ(readMotions({directory, directory / "none"}, simsparkRobot(0)).size(), 3u);
  EXPECT_THROW(readMotions({directory / "none"}, simsparkRobot(0)), KeyframeFileError);
}

TEST_F(KeyframeReaderTest, errorsNameFileLineAndKey) {
  const std::string head = "keyframes:\n  - time: 0.2\n    ";
  EXPECT_EQ(errorOf(head + "LHipPich: 3\n"),
            "m.yaml:3: LHipPich: unknown joint; did you mean \"LHipPitch\"?");
  EXPECT_EQ(errorOf(head + "HipRol: 3\n"), "m.yaml:3: HipRol: unknown joint; did you mean \"HipRoll\"?");
  EXPECT_EQ(errorOf(head + "LToePitch: 3\n"),
            "m.yaml:3: LToePitch: robot " + simsparkRobot(0).name + " has no such joint");
  EXPECT_EQ(errorOf(head + "LToePitch: -3\n", 4), "no error");
  EXPECT_EQ(errorOf(head + "LKneePitch: -90\n"),
            "m.yaml:3: LKneePitch: -90 degrees is out of the limits -1 to 130 of LKneePitch in robot " +
                simsparkRobot(0).name);
  EXPECT_EQ(errorOf(head + "LKneePitch: ten\n"), "m.yaml:3: LKneePitch: \"ten\" is not a number");
  EXPECT_EQ(errorOf(head + "LKneePitch: [1]\n"), "m.yaml:3: LKneePitch: not a number");
  EXPECT_EQ(errorOf(head + "LKneePitch: .nan\n"), "m.yaml:3: LKneePitch: \".nan\" is not a number");
  EXPECT_EQ(errorOf(head + "LKneePitch: 10\n    KneePitch: 10\n"),
            "m.yaml:4: KneePitch: LKneePitch has an angle already in this keyframe");
  EXPECT_EQ(errorOf(head + "LKneePitch: 10\n    LKneePitch: 10\n"), "m.yaml:4: LKneePitch: given twice");
  EXPECT_EQ(errorOf("keyframes:\n  - time: -0.2\n"), "m.yaml:2: time: -0.2 s is negative");
  EXPECT_EQ(errorOf("keyframes:\n  - time: 61\n"), "m.yaml:2: time: 61 s is more than 60 s");
  EXPECT_EQ(errorOf("keyframes:\n  - HeadYaw: 3\n"),
            "m.yaml:2: time: missing; give the seconds from the keyframe before");
  EXPECT_EQ(errorOf("keyframes: 3\n"), "m.yaml:1: keyframes: has to be a list");
  EXPECT_EQ(errorOf("keyframes: []\n"), "m.yaml:1: keyframes: missing or empty");
  EXPECT_EQ(errorOf("keyframe: []\n"), "m.yaml:1: keyframe: unknown key; did you mean \"keyframes\"?");
  EXPECT_EQ(errorOf("mirror: other\n"), "m.yaml:1: mirror: there is no motion other");
  EXPECT_EQ(errorOf("mirror: m\n"), "m.yaml:1: mirror: a mirrored motion cannot be mirrored again");
  EXPECT_EQ(errorOf("ball: [1]\nkeyframes: [{time: 1}]\n"), "m.yaml:1: ball: has to be [x, y] in metres");
  EXPECT_EQ(errorOf("ballReach: [-1, 0]\nkeyframes: [{time: 1}]\n"),
            "m.yaml:1: ballReach: has to be between 0 and 1 m");
  EXPECT_EQ(errorOf(head + "ballX: {RHipRoll: 3}\n"),
            "m.yaml:2: RHipRoll: has a gain for the ball, but no angle in this keyframe");
  EXPECT_EQ(errorOf("ballReach: [0.1, 0]\nkeyframes:\n  - {time: 1, RHipRoll: 24, ballX: {RHipRoll: 50}}\n"),
            "m.yaml:3: RHipRoll: leaves its limits for a ball at the edge of ballReach");
  const std::string frames = "ball: [0.2, 0]\nkeyframes: [{time: 1}]\n";
  EXPECT_EQ(errorOf("kick: {distance: 3}\nkeyframes: [{time: 1}]\n"),
            "m.yaml:1: kick: needs ball, the place that it kicks from");
  EXPECT_EQ(errorOf("kick: {direction: 3}\n" + frames),
            "m.yaml:1: distance: missing; give the metres that the kick carries");
  EXPECT_EQ(errorOf("kick: {distance: 0}\n" + frames), "m.yaml:1: distance: has to be between 0.1 and 50");
  EXPECT_EQ(errorOf("kick: {distanse: 3}\n" + frames),
            "m.yaml:1: distanse: unknown key; did you mean \"distance\"?");
  EXPECT_EQ(errorOf("kick: far\n" + frames),
            "m.yaml:1: kick: has to map distance, direction and contact to numbers");
  EXPECT_EQ(errorOf("3\n"), "m.yaml:1: a motion is a map with the key keyframes (or mirror)");
  EXPECT_EQ(errorOf(""), "m.yaml:1: a motion is a map with the key keyframes (or mirror)");
  EXPECT_EQ(errorOf("keyframes: [\n").substr(0, 22), "m.yaml:2: broken YAML:");
  EXPECT_EQ(errorOf(std::string((1 << 20) + 1, '#')), "m.yaml: is larger than 1 MB");
}

TEST_F(KeyframeReaderTest, aKeyframeNamesAllJointsOrTheMotionSaysThatTheRestStays) {
  const std::string frames =
      "keyframes:\n  - {time: 1, HeadYaw: 1, HeadPitch: 2}\n  - {time: 1, HeadYaw: 3}\n";
  EXPECT_EQ(errorOf(frames),
            "m.yaml:3: HeadPitch: has an angle in another keyframe, but not in this one; give it one, or "
            "write rest: stays next to keyframes if joints that are left out shall stay where they are");
  EXPECT_EQ(errorOf("rest: stays\n" + frames), "no error");
  EXPECT_EQ(errorOf("rest: moves\n" + frames),
            "m.yaml:1: rest: has to be stays: joints that a keyframe leaves out stay where they are");
  EXPECT_EQ(errorOf("keyframes:\n  - {time: 1, HeadYaw: 1}\n  - {time: 1}\n"), "no error") << "a pause";
}

TEST_F(KeyframeReaderTest, aMotionIsForTheRobotsThatItNames) {
  const std::string frames = "\nkeyframes:\n  - {time: 1, HeadYaw: 10}\n";
  for (const char* robots : {"simspark_type0", "simspark_type*", "\"*\"", "[nao_v5, simspark_type0]"})
    EXPECT_EQ(read("robots: " + std::string(robots) + frames).keyframes.size(), 1u) << robots;
  EXPECT_EQ(errorOf("robots: nao*" + frames), "m.yaml:1: robots: the motion is not for robot simspark_type0");
  EXPECT_EQ(errorOf("robots: simspark_type" + frames),
            "m.yaml:1: robots: the motion is not for robot simspark_type0");
  for (const char* robots : {"{nao_v5: 1}", "\"\"", "[]", "[[nao_v5]]"})
    EXPECT_EQ(
        errorOf("robots: " + std::string(robots) + frames),
        "m.yaml:1: robots: has to be the name of a robot, as nao_v5 or simspark_type*, or a list of names")
        << robots;
}

TEST_F(KeyframeReaderTest, motionsOfOtherRobotsAndTheirMirrorImagesAreLeftOut) {
  write("ours.yaml", "keyframes:\n  - {time: 1, HeadYaw: 10}\n");
  write("theirs.yaml", "robots: nao_v5\nkeyframes:\n  - {time: 1, LWristYaw: 1000}\n");
  write("mirrored.yaml", "mirror: theirs\n");
  const auto motions = readMotions(directories, simsparkRobot(0));
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0].name, "ours");
}

TEST_F(KeyframeReaderTest, aSecondDocumentIsRefused) {
  EXPECT_EQ(errorOf("keyframes:\n  - {time: 1, HeadYaw: 1}\n---\nkeyframes: 3\n"),
            "m.yaml:3: a second document begins at ---; a file holds one: take this line out");
}

TEST_F(KeyframeReaderTest, missingFile) {
  try {
    readKeyframeFile(directory / "none.yaml", simsparkRobot(0), directories);
    FAIL();
  } catch (const KeyframeFileError& error) {
    EXPECT_EQ(std::string(error.what()),
              (directory / "none.yaml").string() + ": cannot be read: No such file or directory");
  }
}

}  // namespace
}  // namespace plumbline::motion
