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
  RealSplit split{name, "fit on four segments of 5 s of each of", fit, {}, {}, 20};
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
    R"(Twelve recordings of 6 s: four motions at three firmware gains. In turn, all motions at one gain test the answer
for the other two. There is no repeat, so no part of the gap counts as not closable.
)";
constexpr const char* pendulumLimits =
    R"(These recordings leave some questions open. The electrical side is known (the duty was recorded and
follows the control law), so the missing effects are in motor, gear or load. But published constants of this
motor differ by 40 % in its resistance and 6 % in its torque per ampere. A wrong constant looks like friction
that depends on speed (back-EMF) or like a gain. The mass of the arm and the zero of the angle are not known
either. On a single joint, an offset, a bias of torque and a shifted centre of mass are the same. There is
one unit with one load at 27 to 40 degrees, so friction that depends on temperature cannot be separated from
other friction.
)";
constexpr const char* armText =
    R"(Fourteen motions of 120 s, each recorded twice. Segments of four motions in session 2 are fitted; the test
is all of session 2 of the other motions. The floor is one session's part of the difference between the two
sessions (divided by the square root of two), which includes a new calibration of two joints. Tests whose repeat
ran with other servo settings (prbs_excitation, static_holding) are shown but do not count. The causes, and why
one split closes less: [what the recordings show](../reference/real-recordings.md).
)";
constexpr const char* armLimits =
    R"(These recordings leave some questions open. A servo gain below the published one and links heavier than
their model look alike, because all motions stay within 0.15 rad of one pose; another load or pose is needed.
The gravity torque depends on the zeros of the angles (set by hand, 0.2 rad), on whether the base is level, and
on what is mounted on the gripper. A bias of torque absorbs these. The order of bus transactions leaves 40 % of
5 to 17 ms open, which is a command_delay of some milliseconds. The signs of Rotation, Wrist_Roll and Jaw are
those of the recordings.
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
