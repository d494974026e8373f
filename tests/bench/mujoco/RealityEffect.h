#pragma once
#include <map>
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::reality {

/// What is done to the simulated reality: an effect of the diagnosis's library, or one that it does not have.
/// Written apart from src/gap/effects on purpose: what explains must not be what generates.
struct RealityEffect {
  std::string effect;
  std::string at;    ///< joint, link, foot, "*", "imu", "ground"
  std::string axis;  ///< "x", "y", "z" or empty
  double value = 0;
  /// Where the effect can be built in more than one way, which: side motor|link; heat torque|work; band
  /// excess|whole; load spread|point; com along|stays; speed (of Stribeck's fall); periods (of a ripple).
  std::map<std::string, std::string> how;

  std::string choice(const std::string& key, const std::string& otherwise) const {
    const auto it = how.find(key);
    return it == how.end() ? otherwise : it->second;
  }
  double number(const std::string& key, double otherwise) const {
    const auto it = how.find(key);
    return it == how.end() ? otherwise : std::stod(it->second);
  }
};

struct EffectKind {
  const char* id;
  const char* site;  ///< joint, everywhere, link, imu, foot, ground
  bool hasAxis;
  bool inLibrary;
  const char* unit;
};
/// All that can be done, the contract's effects first.
const std::vector<EffectKind>& effectKinds();
const EffectKind* findKind(const std::string& id);

/// Throws std::runtime_error, one line, for an effect, place or axis that does not fit the robot.
void checkEffect(const RealityEffect& effect, const Mechanism& robot);

/// The joints an effect acts at: all for "*"; of two that share a motor both.
std::vector<int> jointsOf(const RealityEffect& effect, const Mechanism& robot);

/// Masses, lengths and centres changed as the effects say.
Mechanism changedBody(Mechanism robot, const std::vector<RealityEffect>& effects);

Vec3 axisVector(const std::string& axis);

}  // namespace plumbline::reality
