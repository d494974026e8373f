#pragma once
#include <string>

#include "motion/SearchedKick.h"
#include "robot/JointId.h"
#include "trials/WorldOptions.h"

namespace plumbline {

/// Options of the task kick.
struct KickOptions {
  PARAMETERS(KickOptions)
  PARAMETER(std::string, motion, "kickRight", "", Range(), "kick to begin with")
  PARAMETER_CHOICE(side, "right", "kicking foot", "right", "left")
  PARAMETER(double, direction, 0, "deg", Range(-180, 180), "where the ball is to go, to the left of forward")
  PARAMETER_GROUP(motion::KickWish, wish, "what is wanted of the kick")
  PARAMETER(double, spread, 0.01, "m", Range(0, 0.1),
            "largest offset of the ball to each side; the thesis's square has 2 x 2 cm")
  PARAMETER(double, walk, 2, "s", Range(0.2, 10),
            "time of the walk after the kick; a shorter one makes a search faster, not its result better")
  PARAMETER(double, still, 0, "", Range(0, 1),
            "share of the runs in which the robot stands for that time instead of walking: a walk hides that "
            "a robot would fall")
  PARAMETER_GROUP(WorldOptions, world, "robot and worlds")

  Side foot() const { return side == "left" ? Side::left : Side::right; }
};

}  // namespace plumbline
