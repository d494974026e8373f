// What perception and modelling cost and what they are worth: five minutes of walking on the league's physics
// with its sensors' noise. Prints the figures and writes build/bench/modules.json. One argument: minutes (5).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#include "framework/Controller.h"
#include "math/GroundPose.h"
#include "modules/evaluation/ErrorStatistics.h"
#include "modules/simspark/AgentOptions.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/perception/PolarPercepts.h"
#include "support/InProcessServer.h"
#include "support/PerceptionModules.h"

namespace plumbline::test {
namespace {

class Report {
public:
  void add(const char* name, double value, const char* unit, double target) {
    std::printf("%-40s %10.4f %-4s (target <= %g)\n", name, value, unit, target);
    text_ << (text_.str().empty() ? "[\n" : ",\n") << "  {\"name\": \"perception." << name
          << "\", \"value\": " << value << ", \"unit\": \"" << unit
          << "\", \"better\": \"lower\", \"target\": " << target << "}";
  }
  void write(const char* path) const {
    const std::string part = std::string(path) + ".new";
    std::ofstream(part) << text_.str() << "\n]\n";
    std::rename(part.c_str(), path);
  }

private:
  std::ostringstream text_;
};

struct Figures {
  ErrorStatistics withImage, withoutImage;                  ///< [us]
  ErrorStatistics position, heading, ball, nearBall, tilt;  ///< [m, deg, m, m, deg]
  double way = 0, drift = 0;                                ///< [m]
  int falls = 0;
};

void walk(int minutes, Figures& figures) {
  InProcessServer server({});
  auto source = std::make_shared<MessageSource>();
  Controller controller(ControllerOptions{}, perceptionModules());
  controller.objects().set(std::make_shared<AgentOptions>());
  controller.objects().set(source);
  Pose2 before;
  Vec2 wayBefore = Vec2::Zero(), wayMeasured = Vec2::Zero();  // within the last ten metres, summed up
  double stretch = 0;
  int settle = 0, moved = 0;
  for (int i = 0; i < minutes * 3000; ++i) {
    source->text = server.message();
    const auto start = std::chrono::steady_clock::now();
    controller.runCycles(1);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
    const bool image = controller.find<VisionInfo>()->newImage;
    (image ? figures.withImage : figures.withoutImage).add(took.count());

    const GroundTruth& truth = *controller.find<GroundTruth>();
    const Pose2 robot = groundPose(truth.T_field_torso);
    const Vec2 trueStep = before.inverse() * robot.position;
    if (i > 0 && settle == 0) {
      wayBefore += trueStep;
      wayMeasured += controller.find<Odometry>()->step.position;
      stretch += trueStep.norm();
      figures.way += trueStep.norm();
      if (stretch > 10) {
        figures.drift += (wayBefore - wayMeasured).norm();
        wayBefore.setZero();
        wayMeasured.setZero();
        stretch = 0;
      }
    }
    before = robot;
    if (settle > 0) --settle;
    const RobotPose& pose = *controller.find<RobotPose>();
    if (settle == 0 && pose.valid) {
      figures.position.add((pose.pose.position - robot.position).norm());
      figures.heading.add(std::abs(toDegrees(normalizeAngle(pose.pose.heading - robot.heading))));
      const Vec3 up = truth.T_field_torso.linear().row(2);
      figures.tilt.add(
          toDegrees(std::acos(std::clamp(up.dot(controller.find<UprightVec>()->up), -1.0, 1.0))));
      // Nobody can know of a ball put elsewhere before it is seen there.
      if (const BallPos& ball = *controller.find<BallPos>();
          ball.valid && ball.age < 0.02 * (i - moved) - 0.1) {
        const Vec2 trueBall = robot.inverse() * Vec2(truth.ball.head<2>());
        figures.ball.add((ball.field - truth.ball.head<2>()).norm());
        if (trueBall.norm() < 1) figures.nearBall.add((ball.relative - trueBall).norm());
      }
    }
    if (server.robot().fallen()) {  // the walk is not what is measured here
      ++figures.falls;
      server.standUp();
      settle = 150;
    }
    // Every ten seconds the ball lies somewhere else, every second time near the robot.
    if (i % 500 == 0) {
      const Vec2 near = robot * Vec2(0.5, 0.1);
      const Vec2 place = i % 1000 == 0 ? near : Vec2(-0.8 * near);
      moved = i;
      server.robot().world().setBall(Vec3(place.x(), place.y(), 0.042), Vec3::Zero());
    }
    server.walk(Vec2(i % 1000 < 250 ? 0 : 0.3, 0), 0.5 * std::sin(i * 0.01));
  }
}

}  // namespace
}  // namespace plumbline::test

int main(int argc, char** argv) {
  using namespace plumbline::test;
  const int minutes = argc > 1 ? std::atoi(argv[1]) : 5;
  if (minutes < 1 || minutes > 1000) {
    std::fprintf(stderr, "PerceptionBench: minutes '%s' must be a number from 1 to 1000\n", argv[1]);
    return 2;
  }
  Figures f;
  walk(minutes, f);
  std::printf("%d minutes, %.1f m, %d falls\n", minutes, f.way, f.falls);
  Report report;
  report.add("cycle_with_image", f.withImage.quantile(0.5), "us", 150);
  report.add("cycle_without_image", f.withoutImage.quantile(0.5), "us", 20);
  report.add("self_localisation_median", f.position.quantile(0.5), "m", 0.02);
  report.add("self_localisation_p95", f.position.quantile(0.95), "m", 0.05);
  report.add("self_localisation_heading_median", f.heading.quantile(0.5), "deg", 0.2);
  report.add("self_localisation_heading_p95", f.heading.quantile(0.95), "deg", 0.5);
  report.add("ball_on_field_median", f.ball.quantile(0.5), "m", 0.05);
  report.add("ball_on_field_p95", f.ball.quantile(0.95), "m", 0.15);
  report.add("ball_within_1m_median", f.nearBall.quantile(0.5), "m", 0.01);
  report.add("ball_within_1m_p95", f.nearBall.quantile(0.95), "m", 0.03);
  report.add("tilt_p95", f.tilt.quantile(0.95), "deg", 1);
  report.add("odometry_drift_per_metre", f.way > 0 ? f.drift / f.way : 0, "m", 0.05);
  report.write("build/bench/modules.json");
  return 0;
}
