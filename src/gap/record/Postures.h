#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// All joints at 0, or as close to 0 as their limits allow.
std::vector<double> neutralPosture(const Mechanism& robot);

/// A posture by name, from the first of these files that has the robot: FOLDER/postures.yaml (robots, each a
/// map of postures), and of the configuration robots/ROBOT/postures.yaml (the postures) and
/// excitation/postures.yaml (as the first). Joints that a posture does not name are neutral. `hang` is
/// neutral for a robot without postures. Throws ConfigurationError for a broken file.
std::optional<std::vector<double>> namedPosture(const std::string& name, const Mechanism& robot,
                                                const std::string& folder = "");

/// Groups of joints that can move at the same time without disturbing each other much: the first joint of
/// each limb, the second of each, and so on, shifted between limbs. No two joints of a limb are in one group.
std::vector<std::vector<int>> jointsInTurn(const Mechanism& robot);

/// Postures within `share` of the way from home to the limits, at which gravity loads the joints as
/// differently as possible. They are the best of 200 drawn ones, with both signs if a joint can have both.
/// The same seed gives the same postures.
std::vector<std::vector<double>> gravityLoadings(const Mechanism& robot, const std::vector<double>& home,
                                                 double share, int count, std::uint64_t seed);

}  // namespace plumbline::gap
