#pragma once
#include <deque>
#include <optional>

#include "walking/estimation/WalkObserver.h"

namespace plumbline::walking {

/// Observes the walk and compensates the delay of the control loop (section 4.2.5). A measurement shows the
/// effect of commands some cycles ago. So the model predicts the present state from the observation and the
/// actions commanded since then.
class ClosedLoop {
public:
  explicit ClosedLoop(const RobotModel& robot) : observer_(robot) {}

  void reset();
  /// The engine lets `time` of an action pass in this cycle.
  void pass(const WalkAction& action, double time);
  /// The swing foot lands, at a pose in the supporting foot's frame; the other foot carries, or both do.
  void land(const Pose2& T_support_swing, Support next);
  /// The cycle's commands are complete.
  void endCycle();

  /// A new measurement; delay: cycles between a command and the measurement that shows it, at least 1. The
  /// observed state as it is expected when the cycle begins that is planned now; nothing until `delay` cycles
  /// have passed.
  std::optional<WalkState> update(const WalkSensors& sensors, const WalkModel& model, std::size_t delay,
                                  double imuAverage);

  /// What the last measurement shows, as old as the delay.
  const WalkObserver& observed() const { return observer_; }

private:
  struct Segment {
    Support support = Support::both;
    WalkAction action;
    double time = 0;
    bool lands = false;
    Pose2 landing;
    Support next = Support::both;
  };
  /// What was commanded in one cycle; more changes of support than fit are of no account.
  struct Cycle {
    std::array<Segment, 4> segment;
    std::size_t count = 0;
  };

  WalkObserver observer_;
  std::deque<Cycle> underway_;
  Cycle present_;
  Support support_ = Support::both;  ///< commanded now
};

}  // namespace plumbline::walking
