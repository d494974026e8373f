#include "modules/evaluation/LocalizationEvaluation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "framework/WriteFile.h"
#include "math/GroundPose.h"
#include "modules/evaluation/OutputProblems.h"

namespace plumbline {

MAKE_MODULE(LocalizationEvaluation)

void LocalizationEvaluation::init() {
  if (file.empty()) return;
  const std::filesystem::path path(file);
  std::error_code problem;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), problem);
  std::error_code unknown;
  if (!problem && std::filesystem::is_directory(path, unknown))
    problem = make_error_code(std::errc::is_a_directory);
  if (problem) refuse("file", file + ": cannot be written: " + problem.message() + "; choose another file");
  begun_ = true;
}

void LocalizationEvaluation::execute() {
  if (!theGroundTruth->valid) return;
  if (firstTime_ < 0) firstTime_ = theFrameInfo->time;
  lastTime_ = theFrameInfo->time;
  ++cycles_;
  const Vec3 trueUp = theGroundTruth->T_field_torso.linear().row(2);
  tilt_.add(toDegrees(std::acos(std::clamp(trueUp.dot(theUprightVec->up), -1.0, 1.0))));
  if (!theRobotPose->valid) return;
  ++validCycles_;
  const Pose2 robot = groundPose(theGroundTruth->T_field_torso);
  position_.add((theRobotPose->pose.position - robot.position).norm());
  // A heading means little while the robot lies on its front or back.
  if (!theFallState->lying())
    heading_.add(std::abs(toDegrees(normalizeAngle(theRobotPose->pose.heading - robot.heading))));
  if (!theBallPos->valid) return;
  const Vec2 ball = theGroundTruth->ball.head<2>();
  ball_.add((theBallPos->field - ball).norm());
  ballRelative_.add((theBallPos->relative - robot.inverse() * ball).norm());
}

std::string LocalizationEvaluation::report() const {
  const auto summary = [](const ErrorStatistics& errors) {
    return nlohmann::ordered_json{{"median", errors.quantile(0.5)},
                                  {"p95", errors.quantile(0.95)},
                                  {"max", errors.largest()},
                                  {"cycles", errors.count()}};
  };
  nlohmann::ordered_json report;
  report["sim_time_s"] = cycles_ > 0 ? lastTime_ - firstTime_ : 0;
  report["valid_share"] = cycles_ > 0 ? static_cast<double>(validCycles_) / static_cast<double>(cycles_) : 0;
  report["position_error_m"] = summary(position_);
  report["heading_error_deg"] = summary(heading_);
  report["ball_field_error_m"] = summary(ball_);
  report["ball_relative_error_m"] = summary(ballRelative_);
  report["tilt_error_deg"] = summary(tilt_);

  return report.dump(2) + '\n';
}

LocalizationEvaluation::~LocalizationEvaluation() {
  if (!begun_) return;
  try {
    writeFile(file, report());
  } catch (const std::exception& error) {
    object<OutputProblems>().add(std::string("LocalizationEvaluation: ") + error.what() +
                                 "; make room, or choose another file");
  }
}

}  // namespace plumbline
