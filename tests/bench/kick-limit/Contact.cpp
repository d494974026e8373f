#include "Contact.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/GroundPose.h"
#include "training/tasks/BeforeKick.h"

namespace plumbline::bench {
namespace {

constexpr int cyclesAfter = 5, cyclesAround = 2;
constexpr double nearLimit = 0.95;

/// The forward speed of the point of the foot that is next to the ball [m/s].
double footSpeed(simulation::LocalRobot& robot, const Vec3& ball, const Vec2& forward) {
  const RobotModel& model = robot.model();
  double nearest = 1e9, speed = 0;
  for (const char* name : {"rFoot", "rToe"}) {
    const int index = model.linkIndex(name);
    if (index < 0) continue;
    const Link& link = model.links[static_cast<std::size_t>(index)];
    const simulation::BodyState state = robot.world().linkState(robot.robot(), index);
    Pose3 T_world_box = state.pose * Eigen::Translation3d(-link.com) * link.shape.T_link_shape;
    const Vec3 half = link.shape.size / 2;
    const Vec3 inside = (T_world_box.inverse() * ball).cwiseMax(-half).cwiseMin(half);
    const Vec3 point = T_world_box * inside;
    if (const double distance = (ball - point).norm(); distance < nearest) {
      nearest = distance;
      const Vec3 velocity =
          state.linearVelocity + state.angularVelocity.cross(point - state.pose.translation());
      speed = velocity.head<2>().dot(forward);
    }
  }
  return speed;
}

double jointsAtLimit(const training::MotionTrial& trial, const JointArray& before) {
  int fast = 0, all = 0;
  for (const JointId joint : {rHipPitch, rKneePitch, rAnklePitch}) {
    const double rate = (trial.robot.sense().angle[joint] - before[joint]) / training::MotionDriver::dt;
    ++all;
    fast += std::abs(rate) > nearLimit * trial.model.linkMovedBy(joint).maxSpeed;
  }
  return static_cast<double>(fast) / all;
}

}  // namespace

Contact kickContact(training::MotionTrial& trial, const std::string& motion, double spread, unsigned seed) {
  for (int draw = 0; draw < 1000; ++draw) {
    trial.seedStart(seed, draw);
    trial.robot.restart(training::kickPlace, trial.stand);
    trial.restarted();
    if (training::comesToKick(trial)) break;
  }
  trial.seedRun(seed);
  const motion::KeyframeMotion& kick = trial.motion(motion);
  const Pose2 ground = groundPose(trial.robot.torso().pose);
  const Vec2 offset(trial.random(-spread, spread), trial.random(-spread, spread));
  const Vec2 place = ground * Vec2(kick.ball + offset);
  simulation::World& world = trial.robot.world();
  world.setBall(Vec3(place.x(), place.y(), simulation::WorldConfig().field.ballRadius), Vec3::Zero());

  Contact contact;
  contact.from = place;
  const Vec2 forward = Eigen::Rotation2Dd(ground.heading) * Vec2(1, 0);
  std::vector<double> feet;
  int after = 0;
  trial.player.start(kick, trial.robot.sense().angle);
  bool still = false;
  while (after < cyclesAfter) {
    JointArray targets = trial.stand;
    if (!trial.player.finished()) {
      trial.player.step(training::MotionDriver::dt, still);
      targets = trial.player.angles();
    } else if (!contact.touched) {
      break;
    }
    const JointArray before = trial.robot.sense().angle;
    const Vec3 ballBefore = world.ball().pose.translation();
    feet.push_back(footSpeed(trial.robot, ballBefore, forward));
    trial.step(targets);
    still = trial.still();
    if (!contact.touched && !world.ballTouchedBy().empty()) {
      contact.touched = true;
      feet.push_back(footSpeed(trial.robot, ballBefore, forward));
      contact.foot = *std::max_element(feet.end() - std::min<std::ptrdiff_t>(cyclesAround, std::ssize(feet)),
                                       feet.end());
      contact.joints = jointsAtLimit(trial, before);
    }
    if (!contact.touched) continue;
    ++after;
    if (const simulation::BodyState ball = world.ball();
        ball.linearVelocity.norm() > contact.ball.linearVelocity.norm())
      contact.ball = ball;
  }
  return contact;
}

}  // namespace plumbline::bench
