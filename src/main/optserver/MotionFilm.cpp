#include "MotionFilm.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "motion/KeyframePlayer.h"
#include "motion/KeyframeReader.h"
#include "robot/ForwardKinematics.h"
#include "simspark/LeagueRobots.h"
#include "simspark/SceneState.h"
#include "training/MotionTrial.h"
#include "training/tasks/StandUpTask.h"

namespace plumbline {
namespace {

constexpr double walkSeconds = 2, walkSpeed = 0.3;  // behind the motion, as the task's own [s, m/s]
constexpr double longest = 20;                      // [s]
constexpr int falls = 200, every = 2;               // frames: every second cycle
constexpr unsigned seed = 1;                        // the same fall each time, so that films compare

class Camera {
public:
  Camera(training::MotionTrial& trial, int type) : trial_(trial), kinematics_(trial.model) {
    for (const std::string& name : simspark::sceneBodies(type)) links_.push_back(trial.model.linkIndex(name));
  }
  void look() {
    if (cycle_++ % every != 0) return;
    kinematics_.update(trial_.robot.sense().angle);
    const Pose3 torso = trial_.robot.torso().pose;
    // The physics gives the torso's body; the link's frame is at the torso's middle.
    nlohmann::json frame = nlohmann::json::array();
    for (const int link : links_) {
      const Pose3 pose = torso * kinematics_.link(link) *
                         translation(trial_.model.links[static_cast<std::size_t>(link)].com);
      const Eigen::Quaterniond q(pose.linear());
      for (const double value : {pose.translation().x(), pose.translation().y(), pose.translation().z(),
                                 q.x(), q.y(), q.z(), q.w()})
        frame.push_back(std::round(1e4 * value) / 1e4);
    }
    frames_.push_back(std::move(frame));
  }
  nlohmann::json frames() { return std::move(frames_); }

private:
  training::MotionTrial& trial_;
  ForwardKinematics kinematics_;
  std::vector<int> links_;
  int cycle_ = 0;
  nlohmann::json frames_ = nlohmann::json::array();
};

/// Lets the robot of a stand-up fall, and returns the direction; in play it is pushed while it walks. No
/// value for other tasks.
std::optional<int> fallOf(const training::Study& study, training::MotionTrial& trial) {
  if (study.task != "standUp") return std::nullopt;
  const auto options = study.options.as<StandUpOptions>();
  const int direction = options.side();
  const bool inPlay = options.inPlay();
  for (int i = 0; i < falls; ++i) {
    const bool lies = inPlay ? trial.stumble(direction) : trial.fall(direction);
    if (lies && training::liesAs(trial, direction)) break;
  }
  return direction;
}

/// Plays a motion before the camera; its time [s].
double play(const motion::KeyframeMotion& motion, training::MotionTrial& trial, Camera& camera) {
  motion::KeyframePlayer player;
  player.start(motion, trial.robot.sense().angle);
  double played = 0;
  for (; !player.finished() && played < longest; played += training::MotionTrial::dt) {
    player.step(training::MotionTrial::dt, trial.still());
    trial.step(player.angles());
    camera.look();
  }
  return played;
}

}  // namespace

std::string motionFilm(const training::Study& study, const Eigen::VectorXd& parameters,
                       const std::string& name) {
  const std::string text = training::makeTask(study.task, study.options)->file(parameters, "");
  if (text.empty()) return {};
  const int type = study.options.robotType();
  training::MotionTrial trial(type);
  const motion::KeyframeMotion motion = motion::readKeyframeText(text, "found.yaml", trial.model, {});
  Camera camera(trial, type);
  trial.seed(seed);
  const std::optional<int> direction = fallOf(study, trial);
  camera.look();
  double played = play(motion, trial, camera);
  // A motion for the side does half of the work.
  if (direction == 0 && !trial.upright()) played += play(trial.nextStandUp(), trial, camera);
  trial.beginWalk();
  for (double t = 0; t < walkSeconds; t += training::MotionTrial::dt) {
    trial.walkStep(Vec2(walkSpeed, 0), 0);
    camera.look();
  }
  return nlohmann::json{{"kind", "film"},
                        {"name", name},
                        {"type", type},
                        {"seconds", played},
                        {"step", every * training::MotionTrial::dt},
                        {"frames", camera.frames()}}
      .dump();
}

}  // namespace plumbline
