#include "walking/WalkParameters.h"

#include <stdexcept>
#include <string>

namespace plumbline::walking {
namespace {

void inRange(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  const auto text = [](double number) {
    std::string s = std::to_string(number);
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
    return s;
  };
  throw std::invalid_argument("walking parameter " + std::string(name) + " = " + text(value) + " must be " +
                              text(low) + " to " + text(high));
}

}  // namespace

void WalkParameters::check() const {
  inRange("hipHeight", hipHeight, 0.1, 0.4);
  inRange("feetDistance", feetDistance, 0.085, 0.25);
  inRange("torsoPitch", torsoPitch, -0.3, 0.6);
  inRange("stepDuration", stepDuration, 0.1, 1);
  inRange("minStepDuration", minStepDuration, 0.04, stepDuration);
  inRange("maxStepDuration", maxStepDuration, stepDuration, 2);
  inRange("maxVelocity.x", maxVelocity.x(), 0.01, 3);
  inRange("maxVelocity.y", maxVelocity.y(), 0.01, 2);
  inRange("maxBackwardVelocity", maxBackwardVelocity, 0.01, 3);
  inRange("maxTurn", maxTurn, 0.01, 10);
  inRange("maxAcceleration.x", maxAcceleration.x(), 0.01, 100);
  inRange("maxAcceleration.y", maxAcceleration.y(), 0.01, 100);
  inRange("maxTurnAcceleration", maxTurnAcceleration, 0.01, 1000);
  inRange("maxStepForward", maxStepForward, 0.01, 0.4);
  inRange("maxStepBackward", maxStepBackward, 0.01, 0.4);
  inRange("maxStepOutward", maxStepOutward, 0.05, 0.4);
  inRange("minStepOutward", minStepOutward, 0.04, 0.2);
  inRange("stepHeight", stepHeight, 0.001, 0.1);
  inRange("swingStart", swingStart, 0, 0.5);
  inRange("swingEnd", swingEnd, 0.51, 1);
  inRange("swingSmoothness", swingSmoothness, 0, 1);
  inRange("swingSteepness", swingSteepness, 0.5, 3);
  inRange("swingPitch", swingPitch, -0.5, 0.5);
  inRange("pendulumHeight", pendulumHeight, 0.05, 1);
  inRange("copOffset.x", copOffset.x(), -0.06, 0.06);
  inRange("copOffset.y", copOffset.y(), -0.04, 0.04);
  inRange("startDuration", startDuration, 0.04, 1);
  inRange("stopVelocity", stopVelocity, 0.001, 0.5);
  inRange("odometryScale.x", odometryScale.x(), 0.1, 3);
  inRange("odometryScale.y", odometryScale.y(), 0.1, 3);
  inRange("odometryTurnScale", odometryTurnScale, 0.1, 3);
}

}  // namespace plumbline::walking
