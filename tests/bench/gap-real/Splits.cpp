#include "Splits.h"

#include <algorithm>

namespace plumbline::bench {

namespace {

std::vector<RealSplit> pendulumSplits() {
  std::vector<RealSplit> splits;
  const std::vector<std::string> gains = {"kp100", "kp200", "kp800"};
  for (const std::string& tested : gains) {
    RealSplit split{tested, "fit at the other two gains, tested at " + tested, {}, {}, {}, 1e9};
    for (const std::string& gain : gains)
      for (const char* motion : {"lift_and_drop", "sin_sin", "sin_time_square", "up_and_down"})
        (gain == tested ? split.test : split.fit).push_back(gain + "_" + motion);
    splits.push_back(std::move(split));
  }
  return splits;
}

RealSplit armSplit(const std::string& name, const std::vector<std::string>& fit) {
  const std::vector<std::string> all = {
      "actuator_bandwidth", "backlash_detection", "chirp_sweep",         "coupled_joints", "custom_motion",
      "end_effector",       "frequency_sweep",    "friction_gravity",    "multisine",      "prbs_excitation",
      "static_holding",     "step_response",      "trapezoidal_profile", "velocity_ramp"};
  RealSplit split{name, "fit on four windows of 5 s of each of", fit, {}, {}, 20};
  for (const std::string& motion : fit) split.what += " " + motion;
  for (const std::string& motion : all) {
    if (std::ranges::find(fit, motion) != fit.end()) continue;
    split.test.push_back(motion);
    // These two were recorded under other servo settings the second time.
    if (motion != "prbs_excitation" && motion != "static_holding")
      split.repeats[motion] = motion + "_session1";
  }
  return split;
}

constexpr const char* pendulumText =
    R"(Twelve recordings of 6 s: four motions at three firmware gains. All motions at one gain test what was
found at the other two, in turn. There is no repeat, so nothing is taken off as not closable.
)";
constexpr const char* pendulumLimits =
    R"(What these recordings cannot tell: the electrical side is known (the duty was recorded and follows the
control law), so what is missing lies behind it, in motor, gear or load; but published constants of this
motor differ by 40 % in its resistance and 6 % in its torque per ampere, and a wrong constant looks like
friction that depends on speed (back-EMF) or like a gain. The mass of the arm and the zero of the angle
are not known either: an offset, a bias of torque and a centre of mass aside are one thing on one joint.
One unit, one load, 27 to 40 degrees: friction that depends on temperature is not apart from friction.
)";
constexpr const char* armText =
    R"(Fourteen motions of 120 s, each recorded twice. Windows of four in session 2 are fitted, all of session 2
of the others is the test. The floor is one session's part of the difference between the two (over the
square root of two), which holds a new calibration of two joints, too. Tests whose repeat ran under other
servo settings (prbs_excitation, static_holding) are shown and do not count. What the causes are, and why
one split closes less: [what the recordings show](../reference/real-recordings.md).
)";
constexpr const char* armLimits =
    R"(What these recordings cannot tell: a servo gain lower than the published one and links heavier than their
model look alike, as all motions stay within 0.15 rad of one pose: another load or pose is needed. Zeros
of the angles (by hand, 0.2 rad), whether the base stands level and what is mounted on the gripper are in
the gravity torque, which a bias of torque absorbs. The order of bus transactions leaves 40 % of 5 to 17
ms open, which is a command_delay of some milliseconds. Signs of Rotation, Wrist_Roll and Jaw are the
recorder's.
)";

}  // namespace

std::vector<RealRobot> realRobots() {
  return {{"xl330", "xl330_pendulum", "xl330_pendulum", "XL330 servo with a pendulum", 5, pendulumSplits(),
           pendulumText, pendulumLimits},
          {"so101",
           "so101",
           "so101",
           "SO-101 arm",
           6,
           {armSplit("a", {"chirp_sweep", "friction_gravity", "step_response", "velocity_ramp"}),
            armSplit("b", {"actuator_bandwidth", "coupled_joints", "multisine", "trapezoidal_profile"}),
            armSplit("c", {"frequency_sweep", "friction_gravity", "multisine", "backlash_detection"})},
           armText,
           armLimits}};
}

}  // namespace plumbline::bench
