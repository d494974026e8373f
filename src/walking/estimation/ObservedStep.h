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
    if (observed.support != current.begin.support || observed.support == Support::both) {
      if (current.begin.support != Support::both && current.samples.size() >= minSamples) {
        const ObservedStep::Sample& last = current.samples.back();
        current.turnRate = normalizeAngle(current.begin.supportFoot().heading - heading) / last.time;
        finished = current;
        ready = true;
      }
      current = {};
      current.begin = observed;
      current.pendulum = pendulum;
      return;
    }
    const double time = dt * static_cast<double>(current.samples.size() + 1);
    current.samples.push_back({time, observed.supportFoot().position, observed.velocity});
    heading = observed.supportFoot().heading;
  }
  /// The step that has just ended; nullptr if none has since the last call.
  const ObservedStep* take() {
    if (!ready) return nullptr;
    ready = false;
    return &finished;
  }
  void reset() {
    current = {};
    ready = false;
  }

private:
  static constexpr std::size_t minSamples = 2;
  ObservedStep current, finished;
  double heading = 0;
  bool ready = false;
};

}  // namespace plumbline::walking
