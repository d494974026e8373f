#pragma once
#include <map>
#include <string>

#include "robot/MechanismParts.h"
#include "robot/MjcfDefaults.h"

namespace plumbline {

/// The drives of a model of MuJoCo: <position>, <velocity> and <motor> of joints, and <general> where it is
/// one of these. All is brought to the joint: a gear multiplies torques and divides commands.
class MjcfActuators : private XmlElements {
public:
  MjcfActuators(const MjcfDefaults& defaults, MechanismParts& parts, const std::string& file)
      : XmlElements(file), defaults_(defaults), parts_(parts) {}

  /// Gives the joints their servos. A joint without an actuator has no gain.
  void read(const XMLElement& root);

private:
  /// The law of an actuator in its own units: force = gain * ctrl - stiffness * length - damping * speed.
  struct Law {
    double gain = 1, stiffness = 0, damping = 0;
    double dampRatio = 0;
  };
  /// What drives a joint so far.
  struct Drive {
    int actuators = 0;
    bool position = false, velocity = false, motor = false;
    bool damps = false;    ///< its position servo does
    bool limited = false;  ///< an actuator has a limit of its own
  };

  void readOne(const XMLElement& e);
  MechanismParts::Joint& jointOf(const XMLElement& e) const;
  double gearOf(const XMLElement& e) const;
  Law lawOf(const XMLElement& e) const;
  void refuseFilters(const XMLElement& e, const std::string& joint);
  void limit(const XMLElement& e, const Law& law, double gear, Mechanism::Joint& joint, Drive& drive) const;
  void follow();

  const MjcfDefaults& defaults_;
  MechanismParts& parts_;
  std::map<std::string, Drive> drives_;  ///< by joint
};

}  // namespace plumbline
