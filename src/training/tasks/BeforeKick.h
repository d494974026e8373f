#pragma once
#include "math/Pose2.h"
#include "training/MotionDriver.h"

namespace plumbline::training {

/// Where it stands for that [m, rad, field]: nothing is in the way of a ball that is kicked forward from
/// here.
inline const Pose2 kickPlace(Vec2(-10, 5), 0);

/// What a standing robot does before a kick, drawn from its driver's generator (Seekircher 2015, 3.1.1). In
/// three of five runs it walks up to the ball and stops. Else it stands and comes to rest from a lean of up
/// to two degrees. False if it fell or does not stop.
bool comesToKick(MotionDriver& robot);

}  // namespace plumbline::training
