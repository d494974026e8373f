#include "training/tasks/MoveToPosTask.h"

#include <algorithm>
#include <cmath>

#include "framework/CommentLines.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "math/GroundPose.h"
#include "simspark/LeagueRobots.h"
#include "walking/planning/SpeedLimits.h"

namespace plumbline::training {
namespace {

constexpr double longestWay = 40;  // for it [s]
constexpr double near = 0.08;      // within this the robot is there [m]
constexpr double turned = 0.2;     // and with its heading within this [rad]
constexpr int cyclesThere = 15;    // 0.3 s
const Vec3 farBall(-13, -9, simulation::WorldConfig().field.ballRadius);  // nobody walks into it [m]

}  // namespace

MoveToPosTask::MoveToPosTask(const MoveToPosOptions& options)
    : MoveToPosTask(options, ConfigFile("SkillMoveToPos", MotionTrial::directories(0))) {}

MoveToPosTask::MoveToPosTask(const MoveToPosOptions& options, const ConfigFile& file)
    : nearest_(options.nearest),
      farthest_(std::max(nearest_, options.farthest)),
      fall_(options.fall),
      searched_(file.root().section("walk"), firstSteps("moveToPos")) {
  if (file.root().has("plan"))
    readParameters(file.root().section("plan"), ApproachPlannerParameters::parameterList(), &plan_);
  std::string types = "all";
  for (int i = 0; i < numSimsparkTypes(); ++i) {
    types += ", " + std::to_string(i);
    if (options.type == "all" || options.type == std::to_string(i))
      robots_.push_back(std::make_unique<MotionTrial>(i));
  }
  if (robots_.empty())
    throw ConfigurationError("option type: \"" + options.type + "\" is not one of " + types);
}

TaskOutcome MoveToPosTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  MotionTrial& trial = *robots_[static_cast<std::size_t>(seed % robots_.size())];
  trial.seedStart(seed);
  const double metres = std::exp(trial.random(std::log(nearest_), std::log(farthest_)));
  const double direction = trial.random(-pi, pi), heading = trial.random(-pi, pi);
  trial.robot.restart(Pose2(Vec2(metres * Vec2(std::cos(direction), std::sin(direction))), heading),
                      trial.stand);
  trial.restarted();
  trial.robot.world().setBall(farBall, Vec3::Zero());

  const WalkToPoseParameters p = searched_.with(parameters);
  double seconds = 0;
  bool fell = false;
  const WalkLimits limits = walking::walkLimits(trial.gaits.base);
  WalkToPlace way;
  Vec3 speed = Vec3::Zero();
  for (int there = 0; there <= cyclesThere && !fell && seconds < longestWay; seconds += MotionTrial::dt) {
    const Pose2 target = groundPose(trial.robot.torso().pose).inverse();
    const bool arrived = target.position.norm() < near && std::abs(target.heading) < turned;
    WalkCommand command;
    if (!arrived) command = way.update(target, speed, limits, {}, p, plan_);
    speed = trial.walkStep(command.velocity, command.turn, !arrived).speed();
    fell = trial.lying();
    there = arrived ? there + 1 : 0;
  }
  TaskOutcome outcome;
  outcome.cost = seconds + (fell ? fall_ : 0);
  outcome.figures = {{"time", seconds}, {"metres", metres}, {"fell", fell ? 1.0 : 0.0}};
  return outcome;
}

std::string MoveToPosTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                                const std::map<std::string, double>&) const {
  return commentLines(heading) + "walk:\n" + searched_.lines(parameters).text;
}

MAKE_TASK(MoveToPosTask, "moveToPos", "walking to a place without the ball, all types of robots")

}  // namespace plumbline::training
