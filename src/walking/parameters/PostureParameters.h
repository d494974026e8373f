#pragma once
#include "parameters/Parameter.h"

namespace plumbline::walking {

// Attributes: "blends": may differ between the gaits (WalkGaits); "feedback": zero takes a measurement's
// effect away (openLoop).

struct PostureParameters {
  PARAMETERS(PostureParameters)
  PARAMETER(double, hipHeight, 0.20, "m", Range(0.1, 0.4), "height of the hip joints over the sole", "blends")
  PARAMETER(double, feetDistance, 0.11, "m", Range(0.085, 0.25),
            "distance of the soles' centres, walking on the spot", "blends")
  PARAMETER(double, torsoPitch, 0, "rad", Range(-0.3, 0.6), "lean forward", "blends")
  PARAMETER(double, torsoPitchPerSpeed, 0, "rad s/m", Range(-1, 1), "more of the lean per forward speed",
            "blends")
  PARAMETER(double, torsoRoll, 0, "rad", Range(-0.3, 0.3),
            "lean to the supporting leg in the middle of a step", "blends")
  PARAMETER(double, constantHipHeight, 0, "", Range(0, 1),
            "1: the supporting hip keeps its height as the torso leans, 0: the mass does", "blends")
};

struct ArmParameters {
  PARAMETERS(ArmParameters)
  PARAMETER(double, swing, 0, "rad/m", Range(-10, 10), "shoulder pitch per distance of the feet along x",
            "blends")
  PARAMETER(double, shoulderPitch, 1.57, "rad", Range(-2, 2), "pitch of the shoulders", "blends")
  PARAMETER(double, shoulderRoll, 0.25, "rad", Range(-0.01, 1.6), "roll of the shoulders, outward", "blends")
  PARAMETER(double, elbowYaw, 0, "rad", Range(-2, 2), "turns the elbows so that bent ones point outward",
            "blends")
  PARAMETER(double, elbowRoll, 0.6, "rad", Range(-0.01, 1.57), "bend of the elbows", "blends")
};

/// For platforms with position servos.
struct ServoParameters {
  PARAMETERS(ServoParameters)
  PARAMETER(double, hipStiffness, 1, "", Range(0.1, 1), "stiffness of the hip joints", "blends")
  PARAMETER(double, kneeStiffness, 1, "", Range(0.1, 1), "stiffness of the knees", "blends")
  PARAMETER(double, ankleStiffness, 1, "", Range(0.1, 1), "stiffness of the ankles", "blends")
  PARAMETER(double, loadLead, 0, "", Range(0, 2),
            "share of a servo's deviation under the robot's weight that targets compensate", "blends")
  PARAMETER(double, rateLead, 0, "", Range(0, 2),
            "share of a servo's lag behind a moving target that targets lead by", "blends")
};

}  // namespace plumbline::walking
