#include <cmath>

#include "robot/XmlElements.h"

namespace plumbline {
namespace {

using tinyxml2::XMLElement;
using Joint = Mechanism::Joint;

class UrdfReader : private XmlElements {
public:
  using XmlElements::XmlElements;

  MechanismParts read(const std::string& text) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
      failMechanism(file + ":" + std::to_string(document.ErrorLineNum()),
                    std::string("broken XML (") + document.ErrorName() + ")");
    const XMLElement* robot = document.FirstChildElement("robot");
    if (!robot) failMechanism(file, "no <robot>; give a URDF (a xacro file must be expanded first)");
    MechanismParts parts;
    parts.name = attribute(*robot, "name");
    checkName(parts.name, "name", file);
    for (const XMLElement* e = robot->FirstChildElement("link"); e; e = e->NextSiblingElement("link"))
      parts.links.push_back(readLink(*e));
    for (const XMLElement* e = robot->FirstChildElement("joint"); e; e = e->NextSiblingElement("joint"))
      parts.joints.push_back(readJoint(*e));
    warnOfDynamics(*robot, parts);
    return parts;
  }

private:
  /// What stands there is mostly no measurement but what keeps another simulator calm: it is said, not used.
  void warnOfDynamics(const XMLElement& robot, MechanismParts& parts) const {
    for (const XMLElement* e = robot.FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
      const XMLElement* dynamics = e->FirstChildElement("dynamics");
      if (!dynamics || (number(*dynamics, "friction", 0) == 0 && number(*dynamics, "damping", 0) == 0))
        continue;
      parts.warnings.push_back(
          placeOf(*dynamics) +
          ": <dynamics> is not read; if it is measured, give friction and damping in the "
          "servo table");
      return;
    }
  }

  Mechanism::Link readLink(const XMLElement& e) const {
    Mechanism::Link link;
    link.name = attribute(e, "name");
    checkName(link.name, "link", file + ":" + std::to_string(e.GetLineNum()));
    const XMLElement* inertial = e.FirstChildElement("inertial");
    if (!inertial) return link;
    const XMLElement* origin = inertial->FirstChildElement("origin");
    const XMLElement* mass = inertial->FirstChildElement("mass");
    const XMLElement* inertia = inertial->FirstChildElement("inertia");
    if (!mass || !inertia) fail(*inertial, "link " + link.name + ": <inertial> needs <mass> and <inertia>");
    only(origin, {"xyz", "rpy"});
    link.mass = number(*mass, "value");
    if (link.mass < 0)
      fail(*mass, "link " + link.name + ": mass is " + numberText(link.mass) + "; give 0 or more");
    link.com = vector(origin, "xyz", Vec3::Zero());
    const double xx = number(*inertia, "ixx"), yy = number(*inertia, "iyy"), zz = number(*inertia, "izz");
    const double xy = number(*inertia, "ixy"), xz = number(*inertia, "ixz"), yz = number(*inertia, "iyz");
    link.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Vec3 rpy = vector(origin, "rpy", Vec3::Zero());
    if (!rpy.isZero(0)) {
      const Mat3 r = rotationOfRpy(rpy);
      link.inertia = r * link.inertia * r.transpose();
    }
    return link;
  }

  std::string linkOf(const XMLElement& e, const char* end) const {
    const XMLElement* child = e.FirstChildElement(end);
    if (!child) fail(e, std::string("<joint> lacks <") + end + " link=\"...\"/>");
    return attribute(*child, "link");
  }

  MechanismParts::Joint readJoint(const XMLElement& e) const {
    MechanismParts::Joint part;
    Joint& joint = part.joint;
    joint.name = attribute(e, "name");
    const std::string type = attribute(e, "type");
    part.parent = linkOf(e, "parent");
    part.child = linkOf(e, "child");
    const XMLElement* origin = e.FirstChildElement("origin");
    only(origin, {"xyz", "rpy"});
    joint.origin = vector(origin, "xyz", Vec3::Zero());
    joint.rpy = vector(origin, "rpy", Vec3::Zero());
    part.fixed = type == "fixed";
    if (part.fixed) return part;
    checkName(joint.name, "joint", file + ":" + std::to_string(e.GetLineNum()));
    if (type != "revolute" && type != "continuous" && type != "prismatic")
      fail(e, "joint " + joint.name + ": type is \"" + type.substr(0, 40) +
                  "\"; what can be used is revolute, continuous, prismatic and fixed");
    if (type == "prismatic") joint.type = Joint::Type::prismatic;
    const XMLElement* axis = e.FirstChildElement("axis");
    only(axis, {"xyz"});
    joint.axis = vector(axis, "xyz", Vec3::UnitX());
    if (!(joint.axis.norm() > 1e-6)) fail(axis ? *axis : e, "joint " + joint.name + ": the axis is zero");
    joint.axis = unitAxis(joint.axis);
    readLimit(e, type == "continuous", joint);
    if (const XMLElement* mimic = e.FirstChildElement("mimic")) {
      only(mimic, {"joint", "multiplier", "offset"});
      part.driver = attribute(*mimic, "joint");
      joint.driverRatio = number(*mimic, "multiplier", 1);
      joint.driverOffset = number(*mimic, "offset", 0);
    }
    return part;
  }

  void readLimit(const XMLElement& e, bool continuous, Joint& joint) const {
    const XMLElement* limit = e.FirstChildElement("limit");
    only(limit, {"lower", "upper", "effort", "velocity"});
    if (!limit && !continuous) fail(e, "joint " + joint.name + ": <limit> is missing");
    if (limit) {
      joint.maxTorque = number(*limit, "effort", 0);
      joint.maxSpeed = number(*limit, "velocity", 0);
    }
    if (continuous) {
      joint.lower = -Mechanism::maxTurns;
      joint.upper = Mechanism::maxTurns;
      return;
    }
    joint.lower = number(*limit, "lower", 0);
    joint.upper = number(*limit, "upper", 0);
    if (!(joint.lower < joint.upper))
      fail(*limit, "joint " + joint.name + ": lower " + numberText(joint.lower) + " is not below upper " +
                       numberText(joint.upper));
  }
};

}  // namespace

MechanismParts partsOfUrdf(const std::string& text, const std::string& file) {
  return UrdfReader(file).read(text);
}

}  // namespace plumbline
