#include "walking/parameters/WalkGaits.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline::walking {
namespace {

WalkGaits someGaits() {
  WalkGaits gaits{WalkParameters{}};
  gaits.base.speed.maxForward = 1.0;
  gaits.base.speed.maxBackward = 0.5;
  gaits.base.speed.maxTurn = 2;
  gaits.base.posture.hipHeight = 0.20;
  gaits.corner[0].posture.hipHeight = 0.24;  // forward
  gaits.corner[1].posture.hipHeight = 0.18;  // backward
  gaits.corner[2].posture.hipHeight = 0.20;
  gaits.corner[3].posture.hipHeight = 0.22;  // turn
  return gaits;
}

TEST(WalkGaits, onTheSpotAndAtFullSpeedTheyAreTheSetsGiven) {
  const WalkGaits gaits = someGaits();
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), 0).posture.hipHeight, 0.20);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).posture.hipHeight, 0.24);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(-0.5, 0), 0).posture.hipHeight, 0.18);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), 2).posture.hipHeight, 0.22);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0, 0), -2).posture.hipHeight, 0.22);
}

TEST(WalkGaits, betweenTheyAreBlendedByTheShareOfTheSpeed) {
  const WalkGaits gaits = someGaits();
  EXPECT_NEAR(gaits.at(Vec2(0.25, 0), 0).posture.hipHeight, 0.21, 1e-12);
  EXPECT_NEAR(gaits.at(Vec2(0.25, 0), 1).posture.hipHeight, 0.20 + 0.25 * 0.04 + 0.5 * 0.02, 1e-12);
  // More than everything is everything in the same shares.
  EXPECT_NEAR(gaits.at(Vec2(1, 0), 2).posture.hipHeight, 0.23, 1e-12);
}

TEST(WalkGaits, whatMayBeMixedIsWalkedWithTheBase) {
  WalkGaits gaits = someGaits();
  gaits.base.speed.omniForward = 0.5;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(0.5, 0), 0).posture.hipHeight, 0.20);
  EXPECT_NEAR(gaits.at(Vec2(0.75, 0), 0).posture.hipHeight, 0.22, 1e-12);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).posture.hipHeight, 0.24);
}

TEST(WalkGaits, whatHoldsForTheWholeWalkIsTheBases) {
  WalkGaits gaits = someGaits();
  gaits.corner[0].speed.maxForward = 3;
  gaits.corner[0].odometry.delay = 0.1;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).speed.maxForward, 1.0);
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0).odometry.delay, WalkParameters{}.odometry.delay);
}

TEST(WalkGaits, aBadValueIsNamedWithItsCorner) {
  WalkGaits gaits = someGaits();
  gaits.corner[2].step.height = 5;
  try {
    gaits.check();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "sideways: walking parameter step.height must be within [0.001, 0.1], not 5");
  }
}

TEST(WalkGaits, recoveryIsBlendedOverWhateverIsWalked) {
  WalkGaits gaits = someGaits();
  gaits.recovery.step.height = 0.05;
  const double plain = gaits.at(Vec2(1, 0), 0).step.height;
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0, 1).step.height, 0.05);
  EXPECT_NEAR(gaits.at(Vec2(1, 0), 0, 0.5).step.height, (plain + 0.05) / 2, 1e-12);
  // What is not named there stays as it was.
  EXPECT_DOUBLE_EQ(gaits.at(Vec2(1, 0), 0, 1).posture.hipHeight, gaits.at(Vec2(1, 0), 0).posture.hipHeight);
  gaits.recovery.step.height = 5;
  try {
    gaits.check();
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "recovery: walking parameter step.height must be within [0.001, 0.1], not 5");
  }
}

TEST(WalkGaits, aCornersMissingKeyIsTheBases) {
  const ConfigFile file("walking", {"config", "config/robots/simspark_type0"});
  const WalkGaits gaits = readWalkGaits(file.root());
  file.checkUnknown();
  EXPECT_NO_THROW(gaits.check());
  EXPECT_DOUBLE_EQ(gaits.corner[0].posture.feetDistance,
                   file.root()
                       .find<double>("gaits.forward.posture.feetDistance")
                       .value_or(gaits.base.posture.feetDistance));
}

std::string faultOf(const std::string& yaml) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "walk_gaits_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "walking.yaml") << yaml;
  try {
    const ConfigFile file("walking", {folder.string()});
    readWalkGaits(file.root());
    file.checkUnknown();
  } catch (const ConfigurationError& error) {
    return std::string(error.what()).substr((folder / "walking.yaml").string().size());
  }
  return "";
}

TEST(WalkGaits, onlyWhatDeviatesStandsInTheFile) {
  EXPECT_EQ(faultOf("# nothing\n"), "");
  EXPECT_EQ(faultOf("step: {height: 0.03}\ngaits: {turn: {step: {height: 0.02}}}\n"), "");
}

TEST(WalkGaits, aWrongKeyOrValueIsNamedWithItsLine) {
  EXPECT_EQ(faultOf("step:\n  hight: 0.03\n"), ":2: unknown key \"step.hight\"; did you mean \"height\"?");
  EXPECT_EQ(faultOf("stepp: {height: 0.03}\n"), ":1: unknown key \"stepp\"; did you mean \"step\"?");
  EXPECT_EQ(faultOf("step: {height: 3}\n"), ":1: step.height must be within [0.001, 0.1], not 3");
  EXPECT_EQ(faultOf("gaits: {turn: {step: {height: 3}}}\n"),
            ":1: gaits.turn.step.height must be within [0.001, 0.1], not 3");
  // Holds for the whole walk: no gait has it.
  EXPECT_NE(faultOf("gaits: {turn: {speed: {maxTurn: 3}}}\n"), "");
}

TEST(WalkGaits, theBaseTakesCornersAlongThatAreAsItWas) {
  WalkGaits gaits;
  gaits.corner[1].step.height = 0.04;
  gaits.setBase(walkParameter("step.height"), 0.03);
  EXPECT_EQ(gaits.base.step.height, 0.03);
  EXPECT_EQ(gaits.corner[0].step.height, 0.03);
  EXPECT_EQ(gaits.corner[1].step.height, 0.04);
}

TEST(WalkGaits, everyParameterIsReachedByTheFilesPath) {
  WalkGaits gaits;
  std::map<std::string, double*> places;
  WalkGaits::parameterList().visit(
      &gaits, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
        places[path] = std::get<double*>(pointer);
      });
  EXPECT_EQ(places.at("step.height"), &gaits.base.step.height);
  EXPECT_EQ(places.at("gaits.backward.step.height"), &gaits.corner[1].step.height);
  EXPECT_EQ(places.at("gaits.recovery.step.height"), &gaits.recovery.step.height);
  EXPECT_FALSE(places.contains("gaits.backward.speed.maxBackward"));
  std::size_t blending = 0;
  for (const WalkParameter& one : walkParameters()) blending += one.blends;
  EXPECT_EQ(places.size(), walkParameters().size() + 5 * blending);
}

TEST(WalkGaits, theOpenLoopKeepsWhatIsNoFeedback) {
  WalkGaits gaits;
  gaits.base.feedback.hipPitchGain = gaits.corner[0].feedback.hipPitchGain = 1;
  gaits.base.observation.velocityGain = gaits.base.contact.share = 0.1;
  gaits.base.feedback.tiltTolerance = 0.3;
  gaits.recovery.step.height = 0.05;
  gaits.openLoop();
  EXPECT_EQ(gaits.base.feedback.hipPitchGain, 0);
  EXPECT_EQ(gaits.corner[0].feedback.hipPitchGain, 0);
  EXPECT_EQ(gaits.base.observation.velocityGain, 0);
  EXPECT_EQ(gaits.base.contact.share, 0);
  EXPECT_EQ(gaits.base.feedback.tiltTolerance, 0.3);
  EXPECT_EQ(gaits.at(Vec2::Zero(), 0, 1).step.height, gaits.base.step.height);
}

}  // namespace
}  // namespace plumbline::walking
