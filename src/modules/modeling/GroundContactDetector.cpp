#include "modules/modeling/GroundContactDetector.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(GroundContactDetector)

void GroundContactDetector::parametersChanged() {
  if (releaseLoad > contactLoad) refuse("releaseLoad", "must not be above contactLoad");
}

void GroundContactDetector::update(GroundContactState* theGroundContactState) {
  GroundContactState& state = *theGroundContactState;
  const double dt = theFrameInfo->cycleSeconds;
  const double share = timeConstant > 0 ? 1 - std::exp(-dt / timeConstant) : 1;
  const auto upward = [](const FootForceData& sensor) { return sensor.contact ? sensor.force.z() : 0.0; };
  const auto foot = [&](const FootForceData& sole, const FootForceData& toe, double& load, bool& contact) {
    if (theFrameInfo->restarted) load = 0;
    load += share * (std::max(0.0, upward(sole) + upward(toe)) - load);
    contact = load > (contact ? releaseLoad : contactLoad);
  };
  foot(theSensorData->leftFoot, theSensorData->leftToe, state.leftLoad, state.leftContact);
  foot(theSensorData->rightFoot, theSensorData->rightToe, state.rightLoad, state.rightContact);
  state.contact = state.leftContact || state.rightContact;
}

}  // namespace plumbline
