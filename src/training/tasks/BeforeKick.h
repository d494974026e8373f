#pragma once
#include "training/MotionDriver.h"

namespace plumbline::training {

/// What a standing robot does before a kick, drawn from its driver's generator (Seekircher 2015, 3.1.1): in
/// three of five runs it walks up to the ball and stops, else it stands and comes to rest from a lean of up
/// to two degrees. False if it fell or does not stop.
bool comesToKick(motion::MotionDriver& robot);

}  // namespace plumbline::training
