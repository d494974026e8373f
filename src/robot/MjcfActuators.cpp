#include "robot/MjcfActuators.h"

namespace plumbline {
namespace {

using tinyxml2::XMLElement;
using Joint = Mechanism::Joint;

double largest(const Vec2& range) { return range.cwiseAbs().maxCoeff(); }

}  // namespace

void MjcfActuators::read(const XMLElement& root) {
  for (const XMLElement* all = root.FirstChildElement("actuator"); all;
       all = all->NextSiblingElement("actuator"))
    for (const XMLElement* e = all->FirstChildElement(); e; e = e->NextSiblingElement()) readOne(*e);
  for (MechanismParts::Joint& part : parts_.joints) {
    part.hasServo = !part.fixed;
    part.isDriven = drives_.contains(part.joint.name);
  }
  follow();
}

/// A joint without an actuator that follows another has that one's servo.
void MjcfActuators::follow() {
  for (MechanismParts::Joint& part : parts_.joints) {
    const MechanismParts::Joint* driver = part.driver.empty() ? nullptr : parts_.find(part.driver);
    if (!driver || part.isDriven) continue;
    part.joint.servo.kp = driver->joint.servo.kp;
    part.joint.servo.kd = driver->joint.servo.kd;
    part.dampRatio = driver->dampRatio;
    part.isDriven = driver->isDriven;
  }
}

void MjcfActuators::readOne(const XMLElement& e) {
  defaults_.complete(e, "");
  MechanismParts::Joint& part = jointOf(e);
  Joint& joint = part.joint;
  refuseFilters(e, joint.name);
  const Law law = lawOf(e);
  const double gear = gearOf(e);
  Drive& drive = drives_[joint.name];
  const bool moves = law.stiffness > 0, speeds = !moves && law.damping > 0;
  bool& known = moves ? drive.position : speeds ? drive.velocity : drive.motor;
  if (known) fail(e, "joint " + joint.name + " has two actuators of this kind; keep one");
  known = true;
  if (moves) drive.damps = law.damping > 0 || law.dampRatio > 0;
  if (drive.velocity && drive.damps)
    fail(e, "joint " + joint.name +
                " has a <velocity> and a position actuator with damping of its own; "
                "set kv or dampratio of the latter to 0");
  joint.servo.kp += law.stiffness * gear * gear;
  joint.servo.kd += law.damping * gear * gear;
  part.dampRatio += law.dampRatio;
  ++drive.actuators;
  limit(e, law, gear, joint, drive);
}

MechanismParts::Joint& MjcfActuators::jointOf(const XMLElement& e) const {
  for (const char* other : {"tendon", "site", "body", "cranksite", "slidersite"})
    if (e.Attribute(other))
      fail(e, std::string("an actuator acts on a ") + other +
                  ", which the nominal model does not have; give joint=\"...\" instead, and <equality> "
                  "<joint> for joints that move together");
  // For a hinge and a slide it is the same.
  const char* name = e.Attribute("joint") ? e.Attribute("joint") : e.Attribute("jointinparent");
  if (!name) fail(e, std::string("<") + e.Name() + "> lacks joint=\"...\"");
  MechanismParts::Joint* part = parts_.find(name);
  if (part && !part->fixed) return *part;
  std::vector<std::string> names;
  for (const MechanismParts::Joint& joint : parts_.joints)
    if (!joint.fixed) names.push_back(joint.joint.name);
  fail(e, "there is no joint " + std::string(name).substr(0, 60) + suggestion(name, names));
}

double MjcfActuators::gearOf(const XMLElement& e) const {
  const std::vector<double> gear = numbers(e, "gear", 6);
  if (gear.empty()) return 1;
  for (std::size_t i = 1; i < gear.size(); ++i)
    if (gear[i] != 0)
      fail(e, "gear has a number other than its first that is not 0; a hinge or slide has only the first");
  if (!(std::abs(gear[0]) > 1e-9)) fail(e, "gear is 0; leave the actuator out, or give its gear");
  return gear[0];
}

MjcfActuators::Law MjcfActuators::lawOf(const XMLElement& e) const {
  const std::string kind = e.Name();
  if (kind == "motor") return {};
  Law law;
  if (kind == "velocity") {
    law.gain = law.damping = number(e, "kv", 1);
    if (!(law.damping > 0)) fail(e, "kv is " + numberText(law.damping) + "; give it above 0");
    return law;
  }
  if (kind == "position") {
    law.gain = law.stiffness = number(e, "kp", 1);
    law.damping = number(e, "kv", 0);
    law.dampRatio = number(e, "dampratio", 0);
    if (law.damping != 0 && law.dampRatio != 0) fail(e, "has kv and dampratio; give one of them");
  } else if (kind == "general") {
    const std::vector<double> gain = numbers(e, "gainprm"), bias = numbers(e, "biasprm");
    law.gain = gain.empty() ? 1 : gain[0];
    const std::string type = e.Attribute("biastype") ? e.Attribute("biastype") : "none";
    if (type == "none" && law.gain > 0) return law;
    const double last = bias.size() > 2 ? bias[2] : 0;
    const bool position = bias.size() > 1 && bias[1] == -law.gain;
    const bool speed = bias.size() > 1 && bias[1] == 0 && last == -law.gain;
    if (type != "affine" || !(position || speed) || (!bias.empty() && bias[0] != 0))
      fail(e,
           "<general> is no position servo (gainprm kp, biasprm 0 -kp -kv), no speed servo (gainprm kv, "
           "biasprm 0 0 -kv) and no motor (biastype none)");
    if (position) law.stiffness = law.gain;
    (last > 0 ? law.dampRatio : law.damping) = std::abs(last);
  } else {
    fail(e, "<" + kind.substr(0, 40) +
                "> is no actuator that can be used; give position, velocity, motor or general");
  }
  if (!(law.gain > 0) || law.damping < 0 || law.dampRatio < 0)
    fail(e, "gain is " + numberText(law.gain) + ", damping " + numberText(law.damping) +
                "; give a gain above 0 and damping of 0 or more");
  return law;
}

/// A lag that MuJoCo gives an actuator, and properties that it adds to the joint.
void MjcfActuators::refuseFilters(const XMLElement& e, const std::string& joint) {
  for (const char* kind : {"dyntype", "gaintype"})
    if (const char* type = e.Attribute(kind);
        type && std::string_view(type) != "none" && std::string_view(type) != "fixed")
      fail(e, std::string(kind) + " is \"" + std::string(type).substr(0, 40) +
                  "\", which the nominal model does not have; leave it out");
  for (const char* added : {"armature", "damping"})
    if (e.Attribute(added) && number(e, added) != 0)
      fail(e, std::string(added) + " of an actuator is not read; give it to the joint " + joint);
  if (const double lag = number(e, "timeconst", 0); lag != 0)
    parts_.warnings.push_back(placeOf(e) + ": timeconst is not in the nominal model; expect command_lag of " +
                              numberText(lag) + " s at " + joint);
}

void MjcfActuators::limit(const XMLElement& e, const Law& law, double gear, Joint& joint,
                          Drive& drive) const {
  double most = joint.maxTorque;
  const auto lower = [&](double force) {
    drive.limited = true;
    most = std::min(most, std::abs(gear) * force);
  };
  if (const auto force = defaults_.rangeOf(e, "forcerange", "forcelimited")) lower(largest(*force));
  if (const auto ctrl = defaults_.rangeOf(e, "ctrlrange", "ctrllimited");
      ctrl && law.stiffness == 0 && law.damping == 0)
    lower(law.gain * largest(*ctrl));
  if (drive.limited && drive.actuators > 1)
    fail(e, "joint " + joint.name +
                " has several actuators, and one has a limit; give the joint actuatorfrcrange instead");
  joint.maxTorque = most;
}

}  // namespace plumbline
