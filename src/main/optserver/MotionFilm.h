#pragma once
#include <string>

#include "training/Study.h"

namespace plumbline {

/// Film of a motion that was found: played once in the embedded simulator, from lying where the task
/// has a direction to fall to and from standing otherwise, and then two seconds of walking. As JSON
/// {"kind":"film","type":..,"step":s,"frames":[[x,y,z,qx,qy,qz,qw, ... of each body]]}, bodies in the order
/// of web/Geometry.h; empty for a task without a motion. Throws std::exception.
std::string motionFilm(const training::Study& study, const Eigen::VectorXd& parameters,
                       const std::string& name);

}  // namespace plumbline
