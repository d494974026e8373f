#pragma once
#include <string_view>
#include <vector>

#include "robot/JointId.h"
#include "robot/Mechanism.h"

namespace plumbline {

/// The number of every joint of a mechanism, in its order: a humanoid's by name, its own joints in the ranges
/// of ownJointRanges, each range in the order of the file. Left and right joints are a pair if their names
/// differ in nothing but the side; their axes must then be each other's mirror images. noJoint for what
/// slides or is driven by another joint without a humanoid's name: the model holds it at zero. Throws
/// std::invalid_argument for joints that are no mirror images and for more joints than a range has room for.
std::vector<JointId> jointNumbers(const Mechanism& mechanism);

/// Whether two names differ in their side alone: L and R, l and r, Left and Right, left and right at the same
/// place.
bool isLeftOf(std::string_view left, std::string_view right);

}  // namespace plumbline
