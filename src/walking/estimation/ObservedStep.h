#pragma once
#include <vector>

#include "walking/model/LinearInvertedPendulum.h"

namespace plumbline::walking {

/// A pendulum without the ten parameters: what the gait takes the robot for.
struct PlainPendulum {
  Vec2 heights = Vec2(0.25, 0.25);  ///< for the motion along x, y [m]
  Vec2 copOffset = Vec2::Zero();    ///< as LinearInvertedPendulum [m]

  LinearInvertedPendulum with(const ModelParameters& fit) const { return {heights, copOffset, fit}; }
};

/// A step as it was observed: where it began, and the supporting foot and the velocity some times later.
struct ObservedStep {
  struct Sample {
    double time = 0;  ///< since the beginning [s]
    Vec2 foot = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
  };
  PlainPendulum pendulum;
  WalkState begin;      ///< in single support
  double turnRate = 0;  ///< of the torso over the foot [rad/s]
  std::vector<Sample> samples;

  /// Where the model sees it after some time.
  WalkState predicted(const WalkModel& model, double time) const {
    WalkAction action;
    action.duration = time;
    action.turn = turnRate * time;
    return model.move(begin, action, time);
  }
};

/// Cuts what is observed into steps.
class StepRecorder {
public:
  /// The state observed in a cycle of dt [s] and the pendulum walked with.
  void add(const WalkState& observed, const PlainPendulum& pendulum, double dt) {
    if (observed.support != current_.begin.support || observed.support == Support::both) {
      if (current_.begin.support != Support::both && current_.samples.size() >= minSamples) {
        const ObservedStep::Sample& last = current_.samples.back();
        current_.turnRate = normalizeAngle(current_.begin.supportFoot().heading - heading_) / last.time;
        finished_ = current_;
        ready_ = true;
      }
      current_ = {};
      current_.begin = observed;
      current_.pendulum = pendulum;
      return;
    }
    const double time = dt * static_cast<double>(current_.samples.size() + 1);
    current_.samples.push_back({time, observed.supportFoot().position, observed.velocity});
    heading_ = observed.supportFoot().heading;
  }
  /// The step that has just ended; nullptr if none has since the last call.
  const ObservedStep* take() {
    if (!ready_) return nullptr;
    ready_ = false;
    return &finished_;
  }
  void reset() {
    current_ = {};
    ready_ = false;
  }

private:
  static constexpr std::size_t minSamples = 2;
  ObservedStep current_, finished_;
  double heading_ = 0;
  bool ready_ = false;
};

}  // namespace plumbline::walking
