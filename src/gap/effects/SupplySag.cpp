#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Share of the supply lost while all motors together give their largest torque; it falls in proportion to
/// the sum of their torques (robot/SupplyRail.h). With it fall torque and speed limits, or what a DC motor's
/// duty drives.
const Effect supplySag{
    .id = "supply_sag",
    .order = 450,
    .unit = "1",
    .sites = {Site::everywhere},
    .lower = 0,
    .upper = 3,
    .starts = {0.3, 1},
    .sentence = "The supply sags while the motors work: torque and speed limits shrink with their load.",
    .exposedBy = "fast moves of many joints at once",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.supplySag += value; }); },
    .inWalk = true,
    .drawing = {.where = DrawRange::Where::all, .low = 0.8, .high = 2},
};
MAKE_EFFECT(supplySag);

}  // namespace plumbline::gap
