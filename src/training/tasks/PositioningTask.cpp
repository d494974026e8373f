#include "training/tasks/PositioningTask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/CommentLines.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigOverlay.h"
#include "framework/ConfigurationError.h"
#include "math/Angle.h"
#include "math/GroundPose.h"
#include "tactics/approach/FootChoice.h"
#include "walking/planning/SpeedLimits.h"

namespace plumbline::training {
namespace {

constexpr double mostSeconds = 20;        // for the way to the ball
constexpr double mostPerMetre = 2;        // and so many more for each metre of it beyond `start` [s]
constexpr double kickedSpeed = 0.3;       // of a ball that was kicked [m/s]
constexpr double cameraOffset = 0.005;    // at most, in every image of a run, as the league's [m]
constexpr int cyclesAfter = 10;           // after the kick, before the ball goes on alone
const FootChoiceParameters footChoice{};  // as FootSelector's
const Vec2 ballPlace(-6, 0);              // nothing stands in the way of a ball that is kicked from here [m]

/// The option `searched`: the way from afar, the last metres with how exactly the robot stands, everything,
/// or the kick's place.
std::function<bool(const std::string&)> searchedPart(const std::string& part) {
  if (part == "all" || part == "place") return {};
  return [far = part == "far"](const std::string& path) {
    return far == (path.starts_with("walk.") || path.starts_with("approach."));
  };
}

}  // namespace

PositioningTask::PositioningTask(const PositioningOptions& options)
    : type_(options.world.robot.type),
      worlds_(options.world),
      ball_(worlds_.engine()),
      start_(options.start),
      farthest_(std::max(start_, options.farthest)),
      metre_(options.metre),
      fall_(options.fall),
      searched_(ConfigFile("SkillGetBall", MotionTrial::directories(type_)).root().section("positioning"),
                firstSteps("positioning"), searchedPart(options.searched)) {
  const MotionTrial& trial = worlds_.first();
  const std::string& name = options.motion;
  for (const motion::KeyframeMotion& motion : trial.motions) {
    if (!motion.kick || (!name.empty() && motion.name != name)) continue;
    if (!kick_.kick || motion.kick->distance > kick_.kick->distance) kick_ = motion;
  }
  if (!kick_.kick) throw ConfigurationError("option motion: " + name + " is no kick of this robot");
  if (kick_.ball.y() > 0) kick_ = motion::mirrored(kick_);
  if (options.searched == "place") place_.emplace(kick_);
}

/// The way to the ball and the kick, cycle by cycle, as the agent's modules do it.
struct PositioningTask::Walk {
  MotionTrial& trial;
  const motion::KeyframeMotion& kick;
  const BallPositioningParameters& p;
  Vec2 offset;  ///< of the ball that is seen, robot's frame [m]
  BallPositioning positioning{};
  WalkLimits limits = walking::walkLimits(trial.gaits.base);
  Vec3 speed = Vec3::Zero();  ///< of the walk [m/s, rad/s]
  bool right = true;
  double seconds = 0;  ///< until the ball is kicked [s]
  bool fell = false;
  double there = -1;  ///< time at which the ball first lay right [s]; -1: never
  int lost = 0;       ///< times that it then did no more before the robot stood

  Pose2 robot() const { return groundPose(trial.robot.torso().pose); }
  Vec2 ball() const { return trial.robot.world().ball().pose.translation().head<2>(); }
  Vec2 seen() const { return robot().inverse() * ball() + offset; }
  bool kicked() const { return trial.robot.world().ball().linearVelocity.head<2>().norm() > kickedSpeed; }

  void chooseFoot() {
    const double left = (robot().position - ball()).y();  // the ball is to go along x
    right = footFor(left, right ? Side::right : Side::left, footChoice) == Side::right;
  }
  /// A cycle of the walk; true once the robot stands and kicks.
  bool step() {
    chooseFoot();
    const double mirror = right ? 1 : -1;
    const BallPositioning::Wish wish{
        .ball = seen(),
        .heading = normalizeAngle(-mirror * kick.kick->direction - robot().heading),
        .place = Vec2(kick.ball.x(), mirror * kick.ball.y()),
        .speed = speed,
        .limits = limits};
    const bool was = positioning.atBall();
    const WalkCommand command = positioning.update(wish, wish.ball, p, MotionTrial::dt);
    const bool is = positioning.atBall();
    const walking::WalkOutput output = trial.walkStep(command.velocity, command.turn, !is);
    speed = output.speed();
    if (is && there < 0) there = seconds;
    if (was && !is) ++lost;
    seconds += MotionTrial::dt;
    fell = fell || trial.lying();
    return is && output.standing;
  }
  void play() {
    const motion::KeyframeMotion motion =
        motion::shiftedToBall(right ? kick : motion::mirrored(kick), seen());
    trial.player.start(motion, trial.robot.sense().angle);
    bool still = false;
    for (bool gone = false; !trial.player.finished();) {
      trial.player.step(MotionTrial::dt, still);
      trial.step(trial.player.angles());
      still = trial.still();
      gone = gone || kicked();
      if (!gone) seconds += MotionTrial::dt;
    }
  }
};

TaskOutcome PositioningTask::run(const Eigen::VectorXd& parameters, std::uint64_t seed) {
  MotionTrial& trial = worlds_.of(seed);
  trial.seedStart(seed);
  const double way = trial.random(-pi, pi), heading = trial.random(-pi, pi);
  const double metres = farthest_ > start_ ? trial.random(start_, farthest_) : start_;
  const double limit = mostSeconds + mostPerMetre * (metres - start_);
  trial.robot.restart(Pose2(Vec2(ballPlace + metres * Vec2(std::cos(way), std::sin(way))), heading),
                      trial.stand);
  trial.restarted();
  trial.robot.world().setBall(Vec3(ballPlace.x(), ballPlace.y(), simulation::WorldConfig().field.ballRadius),
                              Vec3::Zero());
  const BallPositioningParameters p = place_ ? searched_.first() : searched_.with(parameters);
  const motion::KeyframeMotion kick = place_ ? place_->written(parameters) : kick_;
  const double x = trial.random(-cameraOffset, cameraOffset), y = trial.random(-cameraOffset, cameraOffset);
  Walk walk{.trial = trial, .kick = kick, .p = p, .offset = Vec2(x, y)};

  bool ready = false;
  while (!ready && !walk.fell && walk.seconds < limit) ready = walk.step();
  const Vec2 from = walk.ball();
  Vec2 gone = Vec2::Zero();
  if (ready) {
    walk.play();
    trial.beginWalk();
    for (int i = 0; i < cyclesAfter; ++i) trial.walkStep(Vec2::Zero(), 0, false);
    gone = ball_.roll(trial.robot.world().ball()) - from;
  }
  const double time = ready ? walk.seconds : limit;
  TaskOutcome outcome;
  outcome.cost = time + (walk.fell ? fall_ : 0) +
                 metre_ * (std::max(0.0, kick_.kick->distance - gone.x()) + std::abs(gone.y()));
  outcome.figures = {{"time", time},
                     {"distance", gone.x()},
                     {"aside", std::abs(gone.y())},
                     {"pushed", (from - ballPlace).norm()},
                     {"kicked", ready ? 1.0 : 0.0},
                     {"there", walk.there},
                     {"lost", static_cast<double>(walk.lost)},
                     {"fell", walk.fell ? 1.0 : 0.0}};
  return outcome;
}

std::string PositioningTask::file(const Eigen::VectorXd& parameters, const std::string& heading,
                                  const std::map<std::string, double>&) const {
  if (place_) return motion::motionFile(place_->written(parameters), worlds_.first().model, heading);
  const GroupedLines lines = searched_.lines(parameters);
  return commentLines(heading) + overlayLine("SkillGetBall.yaml", lines.count) + "\npositioning:\n" +
         lines.text;
}

MAKE_TASK(PositioningTask, "positioning", "the way to the ball and the kick")

}  // namespace plumbline::training
