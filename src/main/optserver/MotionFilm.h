#pragma once
#include <string>

#include "training/Study.h"

namespace plumbline {

/// Film of a motion that was found. It is played once in the embedded simulator, and two seconds of walking
/// follow. The robot begins on its feet or, in a task with a direction to fall to, lies on that side. As JSON
/// {"kind":"film","type":..,"step":s,"frames":[[x,y,z,qx,qy,qz,qw, ... of each body]]}, bodies in the order
/// of web/Geometry.h; empty for a task without a motion. Throws std::exception.
std::string motionFilm(const training::Study& study, const Eigen::VectorXd& parameters,
                       const std::string& name);

}  // namespace plumbline
