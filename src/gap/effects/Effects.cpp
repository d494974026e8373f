#include "gap/effects/Effects.h"

#include <algorithm>
#include <stdexcept>

#include "gap/effects/AccelerationLimit.h"
#include "gap/effects/Backlash.h"
#include "gap/effects/BiasForce.h"
#include "gap/effects/ComOffset.h"
#include "gap/effects/CommandDelay.h"
#include "gap/effects/CommandDropout.h"
#include "gap/effects/CoulombFriction.h"
#include "gap/effects/DeadBand.h"
#include "gap/effects/EncoderNonlinearity.h"
#include "gap/effects/ExternalForce.h"
#include "gap/effects/FsrGain.h"
#include "gap/effects/GroundCompliance.h"
#include "gap/effects/GroundFriction.h"
#include "gap/effects/GroundSlope.h"
#include "gap/effects/GyroBias.h"
#include "gap/effects/ImuDelay.h"
#include "gap/effects/ImuMisalignment.h"
#include "gap/effects/JointCompliance.h"
#include "gap/effects/JointOffset.h"
#include "gap/effects/LinkLength.h"
#include "gap/effects/LinkMass.h"
#include "gap/effects/LoadFriction.h"
#include "gap/effects/RotorInertia.h"
#include "gap/effects/ServoDamping.h"
#include "gap/effects/ServoGain.h"
#include "gap/effects/SpeedLimit.h"
#include "gap/effects/StribeckFriction.h"
#include "gap/effects/SupplyVoltage.h"
#include "gap/effects/ThermalDerating.h"
#include "gap/effects/TorqueLimit.h"
#include "gap/effects/ViscousFriction.h"

namespace plumbline::gap {

const std::vector<const Effect*>& effects() {
  static const std::vector<const Effect*> all{
      &commandDelay, &commandDropout,  &servoGain,         &servoDamping,     &torqueLimit,
      &speedLimit,   &coulombFriction, &viscousFriction,   &stribeckFriction, &loadFriction,
      &backlash,     &jointCompliance, &accelerationLimit, &deadBand,         &supplyVoltage,
      &biasForce,    &thermalDerating, &rotorInertia,      &jointOffset,      &encoderNonlinearity,
      &linkMass,     &comOffset,       &linkLength,        &imuMisalignment,  &gyroBias,
      &imuDelay,     &fsrGain,         &groundFriction,    &groundSlope,      &groundCompliance,
      &externalForce};
  return all;
}

const Effect* findEffect(std::string_view id) {
  for (const Effect* effect : effects())
    if (effect->id == id) return effect;
  return nullptr;
}

bool sitsAtJoints(const Effect& effect) {
  return std::ranges::find(effect.sites, Site::joint) != effect.sites.end();
}

std::vector<Place> placesOf(const Effect& effect, const Mechanism& mechanism) {
  std::vector<Place> bare;
  for (const Site site : effect.sites) {
    switch (site) {
      case Site::joint:
        for (int i = 0; i < mechanism.numJoints(); ++i) {
          const auto& joint = mechanism.joints[static_cast<std::size_t>(i)];
          if (joint.driver < 0) bare.push_back({site, i, joint.name});
        }
        break;
      case Site::link:
        for (std::size_t i = 0; i < mechanism.links.size(); ++i)
          bare.push_back({site, static_cast<int>(i), mechanism.links[i].name});
        break;
      case Site::foot:
        for (std::size_t i = 0; i < mechanism.feet.size(); ++i)
          bare.push_back({site, static_cast<int>(i), mechanism.feet[i].name});
        break;
      case Site::everywhere:
        // All joints of a robot with one motor are that one.
        if (!sitsAtJoints(effect) || mechanism.onlyMotor() < 0) bare.push_back({site, -1, "*"});
        break;
      case Site::imu:
        if (mechanism.hasImu) bare.push_back({site, -1, "imu"});
        break;
      case Site::ground:
        if (!mechanism.feet.empty()) bare.push_back({site, -1, "ground"});
        break;
    }
  }
  if (effect.ofServo && mechanism.sharesServo()) bare.push_back({Site::everywhere, -1, "*"});
  if (!effect.hasAxis) return bare;
  std::vector<Place> places;
  for (const Place& place : bare)
    for (const char axis : {'x', 'y', 'z'}) {
      if (place.site == Site::ground && axis == 'z') continue;
      places.push_back(place);
      places.back().axis = axis;
    }
  return places;
}

Place findPlace(const Effect& effect, const Mechanism& mechanism, std::string_view at,
                std::string_view axis) {
  const bool everywhere = std::ranges::find(effect.sites, Site::everywhere) != effect.sites.end();
  if (const int only = mechanism.onlyMotor(); at == "*" && everywhere && sitsAtJoints(effect) && only >= 0)
    at = mechanism.joints[static_cast<std::size_t>(only)].name;
  const std::vector<Place> places = placesOf(effect, mechanism);
  const char letter = axis.empty() ? '\0' : axis.front();
  std::string known;
  for (const Place& place : places) {
    if (place.at == at && place.axis == letter) return place;
    std::string name = place.at;
    if (place.axis) name += std::string(" axis ") + place.axis;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(std::string(effect.id) + " cannot be at '" + std::string(at) +
                              (axis.empty() ? "'" : "' axis '" + std::string(axis) + "'") +
                              "; there is: " + known);
}

}  // namespace plumbline::gap
