#include "modules/evaluation/LocalizationEvaluation.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "math/Angle.h"
#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class LocalizationEvaluationTest : public testing::Test {
protected:
  LocalizationEvaluationTest() {
    truth().valid = pose().valid = ball().valid = true;
    truth().T_field_torso = translation(1, 2, 0.4);
    truth().ball = Vec3(3, 2, 0.04);
    pose().pose = Pose2(1, 2, 0);
    ball().field = {3, 2};
    ball().relative = {2, 0};
  }
  GroundTruth& truth() { return harness->input<GroundTruth>(); }
  RobotPose& pose() { return harness->input<RobotPose>(); }
  BallPos& ball() { return harness->input<BallPos>(); }
  void cycle(double time) {
    harness->input<FrameInfo>().time = time;
    harness->cycle();
  }
  /// What is written when the agent ends.
  nlohmann::json report() {
    harness->module();
    harness.reset();
    EXPECT_FALSE(std::filesystem::exists(folder / "deep/report.json.part"));
    return nlohmann::json::parse(folder.read("deep/report.json"));
  }
  std::vector<std::string> configured(const std::string& file) const {
    folder.write("LocalizationEvaluation.yaml", "file: '" + file + "'\n");
    return {folder.path()};
  }
  test::ScratchFolder folder;
  std::optional<test::ModuleHarness<LocalizationEvaluation>> harness{configured(folder / "deep/report.json")};
};

TEST_F(LocalizationEvaluationTest, writesHowFarTheEstimatesAreOff) {
  for (int i = 0; i < 3; ++i) {
    pose().pose = Pose2(1 + 0.1 * i, 2, fromDegrees(i));
    ball().field = {3, 2 - 0.2 * i};
    cycle(10 + i);
  }
  const nlohmann::json written = report();
  EXPECT_EQ(written["sim_time_s"], 2);
  EXPECT_EQ(written["valid_share"], 1);
  EXPECT_NEAR(written["position_error_m"]["median"], 0.1, 1e-6);
  EXPECT_NEAR(written["position_error_m"]["max"], 0.2, 1e-6);
  EXPECT_NEAR(written["heading_error_deg"]["max"], 2, 1e-6);
  EXPECT_NEAR(written["ball_field_error_m"]["max"], 0.4, 1e-6);
  EXPECT_NEAR(written["ball_relative_error_m"]["max"], 0, 1e-6);
  EXPECT_EQ(written["tilt_error_deg"]["cycles"], 3);
}

TEST_F(LocalizationEvaluationTest, whatIsNotValidDoesNotCountAsAnError) {
  cycle(1);
  pose().valid = false;
  harness->input<UprightVec>().up = (rotationX(0.1)).linear().row(2);
  cycle(2);
  pose().valid = true;
  ball().valid = false;
  harness->input<FallState>().posture = Posture::onBack;
  cycle(3);
  truth().valid = false;
  cycle(4);
  const nlohmann::json written = report();
  EXPECT_EQ(written["sim_time_s"], 2) << "while the truth is known";
  EXPECT_NEAR(written["valid_share"], 2.0 / 3, 1e-6);
  EXPECT_EQ(written["position_error_m"]["cycles"], 2);
  EXPECT_EQ(written["heading_error_deg"]["cycles"], 1) << "it lies in the last";
  EXPECT_EQ(written["ball_field_error_m"]["cycles"], 1);
  EXPECT_NEAR(written["tilt_error_deg"]["max"], toDegrees(0.1), 1e-6);
}

TEST_F(LocalizationEvaluationTest, withoutACycleItsSharesAreZero) {
  const nlohmann::json written = report();
  EXPECT_EQ(written["valid_share"], 0);
  EXPECT_EQ(written["position_error_m"]["cycles"], 0);
}

TEST_F(LocalizationEvaluationTest, aFileThatCannotBeWrittenIsSaidAndLeavesNoPart) {
  harness->module();
  folder.write("deep/report.json/in", "the way");
  testing::internal::CaptureStderr();
  harness.reset();
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "LocalizationEvaluation: cannot write " + folder / "deep/report.json" +
                ": Is a directory; make room, or choose another file\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "deep/report.json.part"));
}

TEST_F(LocalizationEvaluationTest, aFileThatCannotBeIsAnErrorAtTheStart) {
  folder.write("file", "");
  const auto errorOf = [&](const std::string& file) {
    test::ModuleHarness<LocalizationEvaluation> bad(configured(file));
    return thrownBy([&] { bad.module(); });
  };
  const std::string place = folder / "LocalizationEvaluation.yaml" + ":1: file ";
  EXPECT_EQ(
      errorOf(folder / "file/report.json"),
      place + folder / "file/report.json" + ": cannot be written: Not a directory; choose another file");
  EXPECT_EQ(errorOf(folder.path()),
            place + folder.path() + ": cannot be written: Is a directory; choose another file");
}

TEST_F(LocalizationEvaluationTest, anEmptyNameIsNoFile) {
  testing::internal::CaptureStderr();
  { test::ModuleHarness<LocalizationEvaluation>(configured("")).module(); }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace plumbline
