#include "modules/skills/WalkConfig.h"

namespace plumbline {

WalkToPoseParameters readWalkToPose(const Config& config) {
  WalkToPoseParameters walk;
  walk.maxForward = config.get<double>("walk.maxForward", {0.01, 3.0});
  walk.maxBackward = config.get<double>("walk.maxBackward", {0.01, 3.0});
  walk.maxSideways = config.get<double>("walk.maxSideways", {0.01, 3.0});
  walk.maxTurn = config.get<double>("walk.maxTurn", {0.01, 6.0});
  walk.positionGain = config.get<double>("walk.positionGain", {0.01, 20.0});
  walk.headingGain = config.get<double>("walk.headingGain", {0.01, 20.0});
  walk.nearDistance = config.get<double>("walk.nearDistance", {0.0, 5.0});
  walk.turnFirst = config.get<double>("walk.turnFirst", {0.1, 3.2});
  return walk;
}

}  // namespace plumbline
