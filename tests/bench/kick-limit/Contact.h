#pragma once
#include <string>

#include "simulation/physics/BodyState.h"
#include "training/MotionTrial.h"

namespace plumbline::bench {

/// What happens where foot and ball meet.
struct Contact {
  bool touched = false;
  double foot = 0;  ///< greatest forward speed of the foot's point next to the ball, in the cycles around the
                    ///< contact [m/s]
  simulation::BodyState ball;  ///< where it is fastest within 0.1 s of the contact
  Vec2 from = Vec2::Zero();    ///< where it lay [m]
  double joints = 0;  ///< share of the kicking leg's pitch joints within 5 % of their speed limit then
};

/// One kick of a standing robot by this motion with the right foot, the ball within `spread` of its place
/// [m].
Contact kickContact(training::MotionTrial& trial, const std::string& motion, double spread, unsigned seed);

}  // namespace plumbline::bench
