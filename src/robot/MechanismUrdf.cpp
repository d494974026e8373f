#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "framework/NearestName.h"
#include "robot/MechanismParts.h"

namespace plumbline {
namespace {

using tinyxml2::XMLElement;
using Joint = Mechanism::Joint;

class UrdfReader {
public:
  explicit UrdfReader(const std::string& file_) : file(file_) {}

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
    return parts;
  }

private:
  [[noreturn]] void fail(const XMLElement& at, const std::string& what) const {
    failMechanism(file + ":" + std::to_string(at.GetLineNum()), what);
  }

  std::string attribute(const XMLElement& e, const char* name) const {
    const char* text = e.Attribute(name);
    if (!text) fail(e, std::string("<") + e.Name() + "> lacks " + name + "=\"...\"");
    return text;
  }

  /// Refuses attributes that nobody reads, where one of those read may be left out: a misspelt one would be
  /// silently missing.
  void only(const XMLElement* e, const std::vector<std::string>& known) const {
    if (!e) return;
    for (const tinyxml2::XMLAttribute* a = e->FirstAttribute(); a; a = a->Next())
      if (std::find(known.begin(), known.end(), a->Name()) == known.end())
        fail(*e, std::string("<") + e->Name() + "> " + std::string(a->Name()).substr(0, 60) +
                     ": unknown attribute" + suggestion(a->Name(), known));
  }

  /// Takes one number off the front of the text; false at its end.
  bool take(const XMLElement& e, const char* name, std::string_view& text, double& x) const {
    while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
    if (text.empty()) return false;
    if (text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    const bool whole = end == text.data() + text.size() || static_cast<unsigned char>(*end) <= ' ';
    if (error != std::errc() || !whole || !(std::abs(x) < 1e12))
      fail(e, std::string("<") + e.Name() + "> " + name + " is \"" + std::string(text.substr(0, 40)) +
                  "\", no number");
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  }

  double number(const XMLElement& e, const char* name) const {
    const std::string text = attribute(e, name);
    std::string_view rest = text;
    double x = 0, more = 0;
    if (!take(e, name, rest, x) || take(e, name, rest, more))
      fail(e,
           std::string("<") + e.Name() + "> " + name + " is \"" + text.substr(0, 40) + "\"; give one number");
    return x;
  }

  double number(const XMLElement& e, const char* name, double otherwise) const {
    return e.Attribute(name) ? number(e, name) : otherwise;
  }

  Vec3 vector(const XMLElement* e, const char* name, const Vec3& otherwise) const {
    if (!e || !e->Attribute(name)) return otherwise;
    const std::string text = attribute(*e, name);
    std::string_view rest = text;
    Vec3 v;
    double more = 0;
    bool whole = true;
    for (int i = 0; i < 3; ++i) whole = whole && take(*e, name, rest, v[i]);
    if (!whole || take(*e, name, rest, more))
      fail(*e, std::string("<") + e->Name() + "> " + name + " is \"" + text.substr(0, 40) +
                   "\"; give three numbers");
    return v;
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

  const std::string& file;
};

}  // namespace

MechanismParts partsOfUrdf(const std::string& text, const std::string& file) {
  return UrdfReader(file).read(text);
}

}  // namespace plumbline
