#include "walking/WalkParameters.h"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace plumbline::walking {
namespace {

constexpr WalkParameterInfo table[] = {
    {"hipHeight", &WalkParameters::hipHeight, 0.1, 0.4},
    {"feetDistance", &WalkParameters::feetDistance, 0.085, 0.25},
    {"torsoPitch", &WalkParameters::torsoPitch, -0.3, 0.6},
    {"torsoPitchForward", &WalkParameters::torsoPitchForward, -1, 1},
    {"trimForward", &WalkParameters::trimForward, -0.3, 0.3},
    {"brakeLead", &WalkParameters::brakeLead, -0.5, 0.5},
    {"speedAverage", &WalkParameters::speedAverage, 0, 1000, false},
    {"maxForward", &WalkParameters::maxForward, 0.01, 3, false},
    {"maxBackward", &WalkParameters::maxBackward, 0.01, 3, false},
    {"maxSideways", &WalkParameters::maxSideways, 0.01, 2, false},
    {"maxTurn", &WalkParameters::maxTurn, 0.01, 10, false},
    {"mixForward", &WalkParameters::mixForward, 0, 3, false},
    {"mixBackward", &WalkParameters::mixBackward, 0, 3, false},
    {"mixSideways", &WalkParameters::mixSideways, 0, 2, false},
    {"mixTurn", &WalkParameters::mixTurn, 0, 10, false},
    {"sprintPatience", &WalkParameters::sprintPatience, 0, 10, false},
    {"sprintAside", &WalkParameters::sprintAside, 0, 0.35, false},
    {"sprintRise", &WalkParameters::sprintRise, 0, 10, false},
    {"sprintFall", &WalkParameters::sprintFall, 0, 10, false},
    {"sprintSettle", &WalkParameters::sprintSettle, 0, 2, false},
    {"accelerationForward", &WalkParameters::accelerationForward, 0.01, 100},
    {"decelerationForward", &WalkParameters::decelerationForward, 0.01, 100},
    {"accelerationSideways", &WalkParameters::accelerationSideways, 0.01, 100},
    {"accelerationTurn", &WalkParameters::accelerationTurn, 0.01, 1000},
    {"stepDuration", &WalkParameters::stepDuration, 0.08, 1},
    {"minStepDuration", &WalkParameters::minStepDuration, 0.04, 1},
    {"maxStepDuration", &WalkParameters::maxStepDuration, 0.08, 2},
    {"maxStepForward", &WalkParameters::maxStepForward, 0.01, 0.4},
    {"maxStepBackward", &WalkParameters::maxStepBackward, 0.01, 0.4},
    {"maxStepOutward", &WalkParameters::maxStepOutward, 0.05, 0.4},
    {"minFeetDistance", &WalkParameters::minFeetDistance, 0.08, 0.3},
    {"stepHeight", &WalkParameters::stepHeight, 0.001, 0.1},
    {"swingStart", &WalkParameters::swingStart, 0, 0.5},
    {"swingEnd", &WalkParameters::swingEnd, 0.51, 1},
    {"swingSmoothness", &WalkParameters::swingSmoothness, 0, 1},
    {"swingSteepness", &WalkParameters::swingSteepness, 0.5, 3},
    {"swingPitch", &WalkParameters::swingPitch, -0.5, 0.5},
    {"pendulumHeight", &WalkParameters::pendulumHeight, 0.05, 1},
    {"pendulumSideways", &WalkParameters::pendulumSideways, -0.3, 0.5},
    {"copForward", &WalkParameters::copForward, -0.06, 0.06},
    {"copOutward", &WalkParameters::copOutward, -0.04, 0.04},
    {"startDuration", &WalkParameters::startDuration, 0.04, 1, false},
    {"startSpeed", &WalkParameters::startSpeed, 0, 0.3, false},
    {"stopVelocity", &WalkParameters::stopVelocity, 0.001, 0.5, false},
    {"kickDuration", &WalkParameters::kickDuration, 0.08, 1, false},
    {"kickBack", &WalkParameters::kickBack, 0, 0.2, false},
    {"kickForward", &WalkParameters::kickForward, 0, 0.3, false},
    {"delay", &WalkParameters::delay, 0, 0.1},
    {"tiltAverage", &WalkParameters::tiltAverage, 0, 100, false},
    {"ankleRollGain", &WalkParameters::ankleRollGain, -2, 2},
    {"anklePitchGain", &WalkParameters::anklePitchGain, -2, 2},
    {"ankleRollRate", &WalkParameters::ankleRollRate, -0.5, 0.5},
    {"anklePitchRate", &WalkParameters::anklePitchRate, -0.5, 0.5},
    {"stepForwardGain", &WalkParameters::stepForwardGain, -2, 3},
    {"stepSidewaysGain", &WalkParameters::stepSidewaysGain, -2, 3},
    {"swingLevel", &WalkParameters::swingLevel, 0, 1.5},
    {"hipRollGain", &WalkParameters::hipRollGain, -2, 2},
    {"hipPitchGain", &WalkParameters::hipPitchGain, -2, 2},
    {"hipRollRate", &WalkParameters::hipRollRate, -0.5, 0.5},
    {"hipPitchRate", &WalkParameters::hipPitchRate, -0.5, 0.5},
    {"comForwardGain", &WalkParameters::comForwardGain, -2, 3},
    {"comSidewaysGain", &WalkParameters::comSidewaysGain, -2, 3},
    {"tiltTolerance", &WalkParameters::tiltTolerance, 0, 2},
    {"tiltBrake", &WalkParameters::tiltBrake, 0, 50},
    {"observationDelay", &WalkParameters::observationDelay, 0.001, 0.2, false},
    {"observationPosition", &WalkParameters::observationPosition, 0, 1},
    {"observationVelocity", &WalkParameters::observationVelocity, 0, 1},
    {"observationSideways", &WalkParameters::observationSideways, 0, 2},
    {"observationBeside", &WalkParameters::observationBeside, 0, 2},
    {"imuAverage", &WalkParameters::imuAverage, 0, 100, false},
    {"usualAverage", &WalkParameters::usualAverage, 0, 100, false},
    {"recoverFrom", &WalkParameters::recoverFrom, 0, 1},
    {"recoverFull", &WalkParameters::recoverFull, 0, 1},
    {"recoverTime", &WalkParameters::recoverTime, 0, 10, false},
    {"captureMargin", &WalkParameters::captureMargin, -0.05, 1, false},
    {"swingMeasuredPitch", &WalkParameters::swingMeasuredPitch, -1, 2},
    {"swingMeasuredRoll", &WalkParameters::swingMeasuredRoll, -1, 2},
    {"contactShare", &WalkParameters::contactShare, 0, 1},
    {"contactPhase", &WalkParameters::contactPhase, 0.1, 1},
    {"contactWait", &WalkParameters::contactWait, 0, 0.2},
    {"hipHardness", &WalkParameters::hipHardness, 0.1, 1},
    {"kneeHardness", &WalkParameters::kneeHardness, 0.1, 1},
    {"ankleHardness", &WalkParameters::ankleHardness, 0.1, 1},
    {"loadLead", &WalkParameters::loadLead, 0, 2},
    {"rateLead", &WalkParameters::rateLead, 0, 2},
    {"fallRoll", &WalkParameters::fallRoll, 0, 2, false},
    {"fallPitch", &WalkParameters::fallPitch, 0, 2, false},
    {"fallLead", &WalkParameters::fallLead, 0, 1, false},
    {"torsoMeasured", &WalkParameters::torsoMeasured, -1, 2},
    {"torsoRoll", &WalkParameters::torsoRoll, -0.3, 0.3},
    {"constantHipHeight", &WalkParameters::constantHipHeight, 0, 1},
    {"armSwing", &WalkParameters::armSwing, -10, 10},
    {"shoulderPitch", &WalkParameters::shoulderPitch, -2, 2},
    {"shoulderRoll", &WalkParameters::shoulderRoll, -0.01, 1.6},
    {"elbowYaw", &WalkParameters::elbowYaw, -2, 2},
    {"elbowRoll", &WalkParameters::elbowRoll, -0.01, 1.57},
    {"odometryDelay", &WalkParameters::odometryDelay, 0, 0.2, false},
    {"odometryMeasured", &WalkParameters::odometryMeasured, 0, 1, false},
    {"odometryForward", &WalkParameters::odometryForward, 0.1, 3},
    {"odometrySideways", &WalkParameters::odometrySideways, 0.1, 3},
    {"odometryTurn", &WalkParameters::odometryTurn, 0.1, 3},
};

std::string text(double number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%g", number);
  return buffer.data();
}

}  // namespace

std::span<const WalkParameterInfo> walkParameterTable() { return table; }

void WalkParameters::check() const {
  const auto demand = [&](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      throw std::invalid_argument("walking parameter " + std::string(name) + " = " + text(value) +
                                  " must be " + text(low) + " to " + text(high));
  };
  for (const WalkParameterInfo& info : table) demand(info.name, this->*info.value, info.low, info.high);
  demand("minStepDuration", minStepDuration, 0, stepDuration);
  demand("maxStepDuration", maxStepDuration, stepDuration, 10);
}

}  // namespace plumbline::walking
