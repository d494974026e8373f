#pragma once
#include <string>

#include "motion/StandUpChoice.h"
#include "trials/WorldOptions.h"

namespace plumbline {

/// Options of the task standUp.
struct StandUpOptions {
  PARAMETERS(StandUpOptions)
  PARAMETER_CHOICE(direction, "front",
                   "what the robot lies on; from the side the motion rolls it, three times at most while it "
                   "stays on its side, and then it stands up as the agent does",
                   "front", "back", "side")
  PARAMETER(std::string, motion, "", "", Range(),
            "motion to begin with; empty: the one that the agent has for the direction")
  PARAMETER_CHOICE(start, "rest",
                   "rest: the robot lies still, as in the thesis; fall: it still moves as in play, and in "
                   "half of the runs it was pushed while it walked",
                   "rest", "fall")
  PARAMETER(double, weight, 0.08, "1/ms", Range(0, 100), "worth of a millisecond of the motion")
  PARAMETER(double, still, 0, "", Range(0, 1),
            "share of the runs in which the robot stands for two seconds instead of walking; with 0, a found "
            "motion may need the walk's steps to stay upright")
  PARAMETER_GROUP(WorldOptions, world, "robot and worlds")

  static constexpr double walkSeconds = 2;  ///< of what follows the motion (AfterMotion)

  /// As MotionTrial::fall has it: front (1), back (-1) or side (0).
  int side() const { return direction == "front" ? 1 : direction == "back" ? -1 : 0; }
  bool inPlay() const { return start == "fall"; }
  /// The motion to begin with, by its name.
  std::string firstMotion() const {
    const motion::StandUpParameters usual;
    if (!motion.empty()) return motion;
    return direction == "front" ? usual.front : direction == "back" ? usual.back : usual.side;
  }
};

}  // namespace plumbline
