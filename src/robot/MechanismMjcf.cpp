#include <map>

#include "robot/MjcfActuators.h"
#include "robot/MjcfDocument.h"
#include "robot/MjcfSolids.h"

namespace plumbline {
namespace {

using tinyxml2::XMLElement;
using Joint = Mechanism::Joint;

constexpr double noSpeedLimit = 100;   // [rad/s]: the format has none
constexpr double noTorqueLimit = 1e4;  // [N m]
constexpr int deepest = 64;            // bodies within each other
const std::string world = "world";     // what holds a robot that has no free joint

/// The robot of a MuJoCo model: bodies, hinges and slides, servos from its actuators, an IMU from its gyro.
/// The nominal model has no contacts, meshes and tendons: these are left out.
class MjcfReader : private MjcfSolids {
public:
  using MjcfSolids::MjcfSolids;

  MechanismParts read(const std::string& text) {
    const MjcfDocument document(text, file);
    const XMLElement* const root = &document.root();
    parts_.name = root->Attribute("model") ? root->Attribute("model") : "robot";
    checkName(parts_.name, "model", file);
    for (const XMLElement* e = root->FirstChildElement("compiler"); e; e = e->NextSiblingElement("compiler"))
      readCompiler(*e);
    if (const XMLElement* option = root->FirstChildElement("option"))
      parts_.gravity = vector(option, "gravity", parts_.gravity);
    readDefaults(*root);
    bool any = false;
    for (const XMLElement* w = root->FirstChildElement("worldbody"); w;
         w = w->NextSiblingElement("worldbody")) {
      refuseMacros(*w);
      for (const XMLElement* e = w->FirstChildElement("body"); e; e = e->NextSiblingElement("body")) {
        if (any)
          fail(*e, "a second body in the world; a robot is one tree: give the file of the robot alone");
        any = true;
        readBody(*e, "", "", 0);
      }
    }
    if (!any) failMechanism(file, "no <body> in <worldbody>");
    readEqualities(*root);
    MjcfActuators(*this, parts_, file).read(*root);
    readSensors(*root);
    return std::move(parts_);
  }

private:
  void readCompiler(const XMLElement& e) {
    const std::string angle = e.Attribute("angle") ? e.Attribute("angle") : "";
    if (angle == "radian") unit = 1;
    if (angle == "degree") unit = fromDegrees(1);
    if (e.Attribute("eulerseq")) eulerSequence = e.Attribute("eulerseq");
    if (eulerSequence.size() != 3 || eulerSequence.find_first_not_of("xyzXYZ") != std::string::npos)
      fail(e, "eulerseq is \"" + eulerSequence.substr(0, 20) + "\"; give three axes such as xyz");
    if (e.Attribute("autolimits")) rangesHoldByThemselves = !e.Attribute("autolimits", "false");
    if (e.Attribute("coordinate", "global"))
      fail(e, "MuJoCo no longer supports global coordinates; save the model again");
  }

  /// Elements that MuJoCo turns into bodies while it reads; their bodies would be missing silently.
  void refuseMacros(const XMLElement& e) const {
    for (const char* macro : {"frame", "replicate", "attach", "composite", "flexcomp"})
      if (const XMLElement* found = e.FirstChildElement(macro))
        fail(*found, std::string("<") + macro +
                         "> is not followed; save the whole model with MuJoCo (mj_saveLastXML)");
  }

  /// A body's frame is at its joint here; MuJoCo's joint may be elsewhere on the body: everything is shifted.
  void readBody(const XMLElement& e, const std::string& parent, std::string classAround, int depth,
                const Vec3& parentJoint = Vec3::Zero()) {
    if (depth > deepest) fail(e, "bodies are nested too deeply");
    if (e.Attribute("childclass")) classAround = e.Attribute("childclass");
    Mechanism::Link link;
    link.name = e.Attribute("name") ? e.Attribute("name") : "body" + std::to_string(parts_.links.size());
    checkName(link.name, "body", placeOf(e));
    refuseMacros(e);
    if (number(e, "gravcomp", 0) != 0)
      fail(e, "body " + link.name +
                  ": gravcomp takes gravity off it, which the nominal model does not; take it out");
    const XMLElement* hinge = nullptr;
    bool isFree = e.FirstChildElement("freejoint") != nullptr;
    for (const XMLElement* j = e.FirstChildElement("joint"); j; j = j->NextSiblingElement("joint")) {
      complete(*j, classAround);
      const std::string type = j->Attribute("type") ? j->Attribute("type") : "hinge";
      if (type == "free") {
        isFree = true;
        continue;
      }
      if (type != "hinge" && type != "slide")
        fail(*j, "type is \"" + type.substr(0, 40) + "\"; what can be used is hinge, slide and a free base");
      if (hinge) fail(*j, "body " + link.name + " has two joints; put a body between them");
      hinge = j;
    }
    if (isFree && !parent.empty()) fail(e, "body " + link.name + " is free, but no base");
    const Vec3 anchor = hinge ? vector(hinge, "pos", Vec3::Zero()) : Vec3(Vec3::Zero());
    const MjcfLump lump = lumpOfBody(e, classAround);
    link.mass = lump.mass;
    link.com = lump.com - anchor;
    link.inertia = lump.inertia;
    if (parent.empty() && (hinge || !isFree)) {
      Mechanism::Link base;
      base.name = world;
      parts_.links.push_back(base);
    }
    parts_.links.push_back(link);
    if (!isFree) {
      MechanismParts::Joint part;
      part.parent = parent.empty() ? world : parent;
      part.child = link.name;
      const Mat3 turn = rotationOf(e);
      part.joint.origin = vector(&e, "pos", Vec3::Zero()) + turn * anchor - parentJoint;
      part.joint.rpy = rpyOfRotation(turn);
      part.fixed = hinge == nullptr;
      part.joint.name = link.name + "_fixed";
      if (hinge) readJoint(*hinge, part);
      parts_.joints.push_back(part);
    }
    for (const XMLElement* s = e.FirstChildElement("site"); s; s = s->NextSiblingElement("site"))
      if (s->Attribute("name"))
        sites_[s->Attribute("name")] = {link.name, vector(s, "pos", Vec3::Zero()) - anchor, rotationOf(*s)};
    for (const XMLElement* c = e.FirstChildElement("body"); c; c = c->NextSiblingElement("body"))
      readBody(*c, link.name, classAround, depth + 1, anchor);
  }

  MjcfLump lumpOfBody(const XMLElement& e, const std::string& classAround) const {
    if (const XMLElement* inertial = e.FirstChildElement("inertial")) return inertialOf(*inertial);
    MjcfLump sum;
    for (const XMLElement* g = e.FirstChildElement("geom"); g; g = g->NextSiblingElement("geom")) {
      complete(*g, classAround);
      sum.add(lumpOf(*g));
    }
    return sum;
  }

  void readJoint(const XMLElement& e, MechanismParts::Joint& part) {
    Joint& joint = part.joint;
    joint.name = attribute(e, "name");
    checkName(joint.name, "joint", placeOf(e));
    if (number(e, "ref", 0) != 0)
      fail(e, "joint " + joint.name + ": ref is not 0; save the model with its zero where the body is drawn");
    const bool slides = e.Attribute("type", "slide") != nullptr;
    if (slides) joint.type = Joint::Type::prismatic;
    joint.axis = vector(&e, "axis", Vec3::UnitZ());
    if (!(joint.axis.norm() > 1e-6)) fail(e, "joint " + joint.name + ": the axis is zero");
    joint.axis = unitAxis(joint.axis);
    joint.lower = -Mechanism::maxTurns;
    joint.upper = Mechanism::maxTurns;
    if (const auto range = rangeOf(e, "range", "limited")) {
      joint.lower = (slides ? 1 : unit) * range->x();
      joint.upper = (slides ? 1 : unit) * range->y();
    }
    joint.servo.armature = number(e, "armature", 0);
    joint.friction = notNegative(e, "frictionloss");
    joint.damping = notNegative(e, "damping");
    if (number(e, "stiffness", 0) != 0)
      fail(e, "joint " + joint.name +
                  ": stiffness is a spring, which the nominal model does not have; take it out");
    joint.maxTorque = noTorqueLimit;
    joint.maxSpeed = noSpeedLimit;
    if (const auto force = rangeOf(e, "actuatorfrcrange", "actuatorfrclimited"))
      joint.maxTorque = force->cwiseAbs().maxCoeff();
  }

  double notNegative(const XMLElement& e, const char* name) const {
    const double x = number(e, name, 0);
    if (x < 0) fail(e, std::string(name) + " is " + numberText(x) + "; give it 0 or more");
    return x;
  }

  void readEqualities(const XMLElement& root) {
    for (const XMLElement* all = root.FirstChildElement("equality"); all;
         all = all->NextSiblingElement("equality"))
      for (const XMLElement* e = all->FirstChildElement("joint"); e; e = e->NextSiblingElement("joint")) {
        if (!e->Attribute("joint2") || e->Attribute("active", "false")) continue;
        MechanismParts::Joint* part = parts_.find(attribute(*e, "joint1"));
        if (!part) fail(*e, "there is no joint " + attribute(*e, "joint1").substr(0, 60));
        std::vector<double> polynomial = numbers(*e, "polycoef", 5);
        if (polynomial.empty()) polynomial = {0, 1};
        polynomial.resize(5);
        if (polynomial[2] != 0 || polynomial[3] != 0 || polynomial[4] != 0)
          fail(*e, "a joint follows another by a straight line; polycoef has more");
        part->driver = attribute(*e, "joint2");
        part->joint.driverOffset = polynomial[0];
        part->joint.driverRatio = polynomial[1];
      }
  }

  void readSensors(const XMLElement& root) {
    for (const XMLElement* all = root.FirstChildElement("sensor"); all;
         all = all->NextSiblingElement("sensor"))
      for (const char* kind : {"gyro", "accelerometer"})
        if (const XMLElement* e = all->FirstChildElement(kind)) {
          const auto site = sites_.find(attribute(*e, "site"));
          if (site == sites_.end()) fail(*e, "there is no site " + attribute(*e, "site").substr(0, 60));
          if (!parts_.imuLink.empty() && parts_.imuLink != site->second.link) continue;
          parts_.imuLink = site->second.link;
          (kind[0] == 'g' ? parts_.imu.gyro : parts_.imu.accelerometer) = site->second.place;
          parts_.imu.rpy = rpyOfRotation(site->second.turn);
        }
  }

  struct SitePlace {
    std::string link;
    Vec3 place;
    Mat3 turn;
  };
  MechanismParts parts_;
  std::map<std::string, SitePlace> sites_;
};

}  // namespace

MechanismParts partsOfMjcf(const std::string& text, const std::string& file) {
  return MjcfReader(file).read(text);
}

}  // namespace plumbline
