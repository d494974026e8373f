#include <cmath>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

namespace {

constexpr double most = 100;  // of the model's largest torque

}  // namespace

/// The servo falls short by its duty instead of by its torque. At its largest duty the motor gives this
/// torque while it stands still, and less by its back EMF while it turns. So it brakes with more torque than
/// a limit of torque allows, and drives with less.
const Effect dutyLimit{
    .id = "duty_limit",
    .order = 480,
    .unit = "N m",
    .sites = {Site::joint},
    .nominal = HUGE_VAL,
    .lower = 0.03,
    .upper = most,
    .starts = {0.4, 1, 2.5},
    .reciprocal = true,
    .ofServo = true,
    .setting = true,
    .sentence = "The servo of {at} falls short by its duty, not by its torque.",
    .exposedBy = "steps and fast moves",
    .scale = [](const Mechanism& m, const Place& p) { return std::max(0.01, jointOf(m, p).maxTorque); },
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          atJoints(plant, place,
                   [value](JointPlant& joint) { joint.fullDutyTorque = std::isfinite(value) ? value : 0; });
        },
    .inWalk = true,
    .nominalIsNone = true,
    .drawing = {.where = DrawRange::Where::joint,
                .low = 0.15,
                .high = 0.5,
                .unit = DrawRange::Unit::torque,
                .growth = DrawRange::Growth::limit},
};
MAKE_EFFECT(dutyLimit);

}  // namespace plumbline::gap
