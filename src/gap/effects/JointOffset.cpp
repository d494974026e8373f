#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Link angle minus measured angle.
const Effect jointOffset{
    .id = "joint_offset",
    .order = 190,
    .unit = "rad",
    .sites = {Site::joint},
    .lower = -0.3,
    .upper = 0.3,
    .starts = {-0.05, 0.05},
    .linear = true,
    .sentence = "The zero of {at} is wrong: the link is not where the encoder says.",
    .exposedBy = "static poses in several postures",
    .apply = [](Plant& plant, const Place& place, double value,
                int) { atJoints(plant, place, [value](JointPlant& joint) { joint.offset += value; }); },
    .inWalk = true,
    .alike = {"bias_force", 13},
    .screening = {.inNeighbours = true, .underLoad = Screening::UnderLoad::anyLeg},
    .drawing = {.where = DrawRange::Where::joint, .low = 0.04, .high = 0.15, .bothSigns = true},
    .perJointFit = {.rank = 90},
    .planting = {.rank = 7,
                 .apply =
                     [](const ModelAndRuns& data, const Place& place, double value) {
                       // The servo closes its loop over its encoder: its target is in the encoder's angle,
                       // too.
                       Mechanism::Joint& joint = data.robot.joints[static_cast<std::size_t>(place.index)];
                       joint.lower -= value;
                       joint.upper -= value;
                       for (Run& run : data.runs)
                         for (const ChannelKind kind : {ChannelKind::command, ChannelKind::position})
                           shiftChannel(run, kind, joint.name, -value);
                     }},
};
MAKE_EFFECT(jointOffset);

}  // namespace plumbline::gap
