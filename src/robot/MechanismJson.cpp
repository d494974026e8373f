#include <algorithm>
#include <cmath>

#include "robot/MechanismFile.h"
#include "robot/MechanismObject.h"

namespace plumbline {
namespace {

using nlohmann::json;
using Joint = Mechanism::Joint;
using Object = MechanismObject;

Mat3 inertiaOf(const Object& link) {
  const auto i = link.vector<6>("inertia", "[ixx, iyy, izz, ixy, ixz, iyz] about the centre of mass, kg m^2");
  Mat3 m;
  m << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  return m;
}

Shape readShape(const Object& object, const Vec3& com) {
  object.only({"box", "sphere", "capsule", "centre", "rpy"});
  if (object.has("box") + object.has("sphere") + object.has("capsule") != 1)
    object.fail("give one of box: [x, y, z], sphere: radius and capsule: [radius, length], in m");
  Shape shape;
  if (object.has("box")) {
    shape.size = object.vector<3>("box", "its edge lengths [x, y, z] in m");
    if (!(shape.size.minCoeff() > 0)) object.fail("box: an edge is not above 0");
  } else if (object.has("sphere")) {
    shape.kind = Shape::Kind::sphere;
    shape.size.x() = object.positive("sphere", "its radius in m, above 0");
  } else {
    shape.kind = Shape::Kind::capsule;
    const Vec2 size = object.vector<2>("capsule", "[radius, length between the caps] in m");
    if (!(size.minCoeff() > 0)) object.fail("capsule: radius or length is not above 0");
    shape.size = Vec3(size.x(), 0, size.y());
  }
  shape.T_link_shape = translation(object.vector3("centre", com));
  if (object.has("rpy")) shape.T_link_shape.linear() = rotationOfRpy(object.vector3("rpy", Vec3::Zero()));
  return shape;
}

Mechanism::Link readLink(const std::string& name, const Object& object) {
  object.only({"mass", "com", "inertia", "shape", "collides"});
  Mechanism::Link link;
  link.name = name;
  link.mass = object.positive("mass", "a mass in kg above 0");
  link.com = object.vector<3>("com", "[x, y, z] in m");
  link.inertia = inertiaOf(object);
  if (object.has("shape"))
    link.shape = readShape(object.child("shape", "{box: [x, y, z]}, a sphere or a capsule"), link.com);
  link.collides = object.flag("collides");
  if (link.collides && !link.shape) object.fail("collides, but has no shape; give it one");
  return link;
}

void readMotor(const Object& motor, Servo& servo) {
  motor.only({"kt", "R", "vin", "error_gain", "kp_firmware", "max_pwm"});
  servo.kt = motor.positive("kt", "the motor's constant in N m/A at the joint");
  servo.R = motor.positive("R", "its resistance in Ohm");
  servo.vin = motor.positive("vin", "the supply in V");
  servo.errorGain = motor.positive("error_gain", "the share of the supply per rad and unit of kp_firmware");
  servo.kpFirmware = motor.atLeast(0, "kp_firmware", "the gain in the firmware's unit");
  servo.maxPwm = motor.positive("max_pwm", "the largest share of the supply, up to 1");
}

const std::vector<std::string> servoKeys = {"kp", "kd", "armature", "model", "dc_motor", "type"};

void readServo(const Object& object, Servo& servo) {
  bool takesPositions = true;
  if (object.has("model")) {
    const std::string model = object.text("model", "position, dc_motor or torque");
    if (model != "position" && model != "dc_motor" && model != "torque")
      object.fail("model is \"" + model.substr(0, 40) + "\"; give position, dc_motor or torque");
    servo.model = model == "dc_motor" ? Servo::Model::dcMotor : Servo::Model::position;
    takesPositions = model != "torque";
  }
  if (object.has("dc_motor") || servo.model == Servo::Model::dcMotor)
    readMotor(object.child("dc_motor", "{kt, R, vin, error_gain, kp_firmware, max_pwm}"), servo);
  if (!takesPositions && object.has("kp") && object.number("kp", "") != 0)
    object.fail("model is torque, which has no gain kp; leave kp out, or give model position");
  servo.kp = takesPositions ? object.positive("kp", "the servo's gain in N m/rad, above 0") : 0;
  servo.kd = !takesPositions && !object.has("kd")
                 ? 0
                 : object.atLeast(0, "kd", "the servo's damping in N m s/rad, 0 or more");
  servo.armature = object.atLeast(0, "armature", "the rotor's inertia at the joint in kg m^2, 0 or more");
}

void readServoType(const Object& object, MechanismParts::Joint& part) {
  if (!object.has("type")) return;
  part.servoType = object.text("type", "the name of its type, such as MX28");
  checkName(part.servoType, object.place + ": type", object.file);
}

void readEncoder(const Object& object, Joint& joint) {
  if (!object.has("encoder")) return;
  const std::string side = object.text("encoder", "motor or link");
  if (side != "motor" && side != "link")
    object.fail("encoder is \"" + side.substr(0, 40) + "\"; give motor or link");
  joint.encoder = side == "link" ? Joint::Encoder::link : Joint::Encoder::motor;
}

void readDriver(const Object& object, MechanismParts::Joint& part) {
  if (!object.has("driven_by")) return;
  part.driver = object.text("driven_by", "the joint whose motor moves this one too");
  part.joint.driverRatio = object.number("driver_ratio", 1.0);
  part.joint.driverOffset = object.number("driver_offset", 0.0);
}

void readPassive(const Object& object, Joint& joint) {
  if (object.has("friction"))
    joint.friction = object.atLeast(0, "friction", "the joint's dry friction in N m, 0 or more");
  if (object.has("damping"))
    joint.damping = object.atLeast(0, "damping", "the joint's own damping in N m s/rad, 0 or more");
}

void readLimits(const Object& object, Joint& joint) {
  joint.maxTorque = object.positive("max_torque", "the motor's limit in N m, above 0");
  joint.maxSpeed = object.positive("max_speed", "the motor's limit in rad/s, above 0");
}

MechanismParts::Joint readJoint(const json& value, std::size_t index, const std::string& file) {
  std::string place = "joints[" + std::to_string(index) + "]";
  const std::string name = Object(value, place, place, file).text("name", "its name");
  checkName(name, place + ": joint", file);
  const Object object(value, "joint " + name, place, file);
  object.only({"name", "type", "parent", "child", "origin", "rpy", "axis", "lower", "upper", "max_torque",
               "max_speed", "encoder", "driven_by", "driver_ratio", "driver_offset", "servo", "friction",
               "damping"});
  MechanismParts::Joint part;
  Joint& joint = part.joint;
  joint.name = name;
  if (object.has("type")) {
    const std::string type = object.text("type", "revolute, prismatic or fixed");
    if (type != "revolute" && type != "prismatic" && type != "fixed")
      object.fail("type is \"" + type.substr(0, 40) + "\"; give revolute, prismatic or fixed");
    part.fixed = type == "fixed";
    if (type == "prismatic") joint.type = Joint::Type::prismatic;
  }
  part.parent = object.text("parent", "the link that holds it");
  part.child = object.text("child", "the link it moves");
  joint.origin = object.vector<3>("origin", "[x, y, z] in m");
  joint.rpy = object.vector3("rpy", Vec3::Zero());
  if (part.fixed) return part;
  joint.axis = object.vector<3>("axis", "[x, y, z], length 1");
  if (std::abs(joint.axis.norm() - 1) > 1e-3)
    object.fail("axis has length " + numberText(joint.axis.norm()) + "; give it length 1");
  joint.axis = unitAxis(joint.axis);
  joint.lower = object.number("lower", "the lower limit in rad");
  joint.upper = object.number("upper", "the upper limit in rad");
  if (!(joint.lower < joint.upper))
    object.fail("lower " + numberText(joint.lower) + " is not below upper " + numberText(joint.upper));
  readLimits(object, joint);
  readPassive(object, joint);
  readEncoder(object, joint);
  readDriver(object, part);
  const Object servo = object.child("servo", "{kp, kd, armature}");
  servo.only(servoKeys);
  readServo(servo, joint.servo);
  readServoType(servo, part);
  part.hasServo = true;
  return part;
}

MechanismParts::Foot& footOf(MechanismParts& parts, const std::string& name) {
  for (MechanismParts::Foot& foot : parts.feet)
    if (foot.foot.name == name) return foot;
  parts.feet.emplace_back();
  parts.feet.back().foot.name = name;
  return parts.feet.back();
}

void readFeet(const Object& root, MechanismParts& parts) {
  if (root.has("feet")) {
    if (!root.value["feet"].is_array()) root.fail("feet is no list; write [ {...}, ... ]");
    for (std::size_t i = 0; i < root.value["feet"].size(); ++i) {
      const json& value = root.value["feet"][i];
      const std::string path = "feet[" + std::to_string(i) + "]";
      const std::string name = Object(value, "feet", path, root.file).text("name", "the foot's name");
      checkName(name, "feet: foot", root.file);
      const Object object(value, "foot " + name, path, root.file);
      object.only({"name", "link", "sole_centre", "sole_size"});
      MechanismParts::Foot& foot = footOf(parts, name);
      foot.link = object.text("link", "the link that stands on the ground");
      foot.foot.soleCentre = object.vector<3>("sole_centre", "[x, y, z] in m");
      foot.foot.soleSize = object.vector<3>("sole_size", "[x, y, z] in m");
      if (foot.foot.soleSize.minCoeff() <= 0) object.fail("sole_size is not above 0");
    }
  }
  if (!root.has("fsr")) return;
  const Object fsr = root.child("fsr", "");
  for (const auto& [key, position] : fsr.value.items()) {
    const std::size_t dot = key.find('.');
    const std::string corner = dot == std::string::npos ? "" : key.substr(dot + 1);
    if (corner != "FrontLeft" && corner != "FrontRight" && corner != "RearLeft" && corner != "RearRight")
      fsr.fail("\"" + key.substr(0, 60) +
               "\" is no sensor; write FOOT.CORNER, corner FrontLeft, FrontRight, RearLeft or RearRight");
    checkName(key.substr(0, dot), "fsr: foot", root.file);
    footOf(parts, key.substr(0, dot))
        .foot.sensors.push_back({corner, fsr.vector<3>(key.c_str(), "[x, y, z] in m")});
  }
}

void readImu(const Object& root, MechanismParts& parts) {
  if (!root.has("imu")) return;
  const Object imu = root.child("imu", "");
  imu.only({"link", "gyro", "accelerometer", "rpy"});
  parts.imuLink = imu.text("link", "the link that carries it");
  parts.imu.gyro = imu.vector3("gyro", Vec3::Zero());
  parts.imu.accelerometer = imu.vector3("accelerometer", Vec3::Zero());
  parts.imu.rpy = imu.vector3("rpy", Vec3::Zero());
}

/// What both forms have besides links and joints. `source` and `notes` are for people.
const std::vector<std::string> restKeys = {"base_link", "gravity", "rates",  "imu",  "feet",
                                           "fsr",       "groups",  "source", "notes"};

void readGroups(const Object& root, MechanismParts& parts) {
  if (!root.has("groups")) return;
  const Object groups = root.child("groups", "{ NAME: [JOINT, ...], ... }");
  for (const auto& [name, list] : groups.value.items()) {
    checkName(name, "groups: group", root.file);
    MechanismParts::Group& group = parts.groups.emplace_back();
    group.name = name;
    if (!list.is_array()) groups.fail("group " + name + " is no list; write [JOINT, ...]");
    for (const json& joint : list) {
      if (!joint.is_string()) groups.fail("group " + name + " has an entry that is not the name of a joint");
      group.joints.push_back(joint.get<std::string>());
    }
  }
}

void readRest(const Object& root, MechanismParts& parts) {
  if (root.has("base_link")) parts.base = root.text("base_link", "the link at the root");
  parts.gravity = root.vector3("gravity", parts.gravity);
  if (root.has("rates")) {
    const Object rates = root.child("rates", "");
    rates.only({"control_hz"});
    parts.controlHz = rates.positive("control_hz", "cycles per second, above 0");
  }
  readImu(root, parts);
  readFeet(root, parts);
  readGroups(root, parts);
}

/// "RHipYawPitch is driven by the LHipYawPitch motor": files made before `driven_by` say it in a note.
void readDriverNotes(const Object& root, MechanismParts& parts) {
  if (!root.has("notes") || !root.value["notes"].is_array()) return;
  for (const json& note : root.value["notes"]) {
    if (!note.is_string()) continue;
    const std::string text = note.get<std::string>();
    static const std::string middle = " is driven by the ";
    const std::size_t at = text.find(middle);
    if (at == std::string::npos) continue;
    const std::size_t from = at + middle.size(), end = text.find(" motor", from);
    if (end == std::string::npos) continue;
    MechanismParts::Joint* joint = parts.find(text.substr(0, at));
    const std::string driver = text.substr(from, end - from);
    if (joint && joint->driver.empty() && parts.find(driver)) joint->driver = driver;
  }
}

}  // namespace

MechanismParts partsOfJson(const json& value, const std::string& file) {
  const Object root(value, "", "", file);
  std::vector<std::string> known = {"name", "units", "links", "joints"};
  known.insert(known.end(), restKeys.begin(), restKeys.end());
  root.only(known);
  MechanismParts parts;
  parts.name = root.text("name", "the robot's name");
  checkName(parts.name, "name", file);
  const Object links = root.child("links", "{ NAME: {mass, com, inertia}, ... }");
  for (const auto& [name, link] : links.value.items()) {
    checkName(name, "links: link", file);
    parts.links.push_back(readLink(name, Object(link, "link " + name, "links." + name, file)));
  }
  const json& joints = root.at("joints", "[ {name, parent, child, ...}, ... ]");
  if (!joints.is_array()) root.fail("joints is no list; write [ {...}, ... ]");
  for (std::size_t i = 0; i < joints.size(); ++i) parts.joints.push_back(readJoint(joints[i], i, file));
  readRest(root, parts);
  readDriverNotes(root, parts);
  return parts;
}

void applyServoTable(const json& value, const std::string& file, MechanismParts& parts) {
  const Object root(value, "", "", file);
  std::vector<std::string> known = {"joints"};
  known.insert(known.end(), restKeys.begin(), restKeys.end());
  root.only(known);
  std::vector<std::string> jointKeys = {"max_torque",   "max_speed",     "encoder",  "driven_by",
                                        "driver_ratio", "driver_offset", "friction", "damping"};
  jointKeys.insert(jointKeys.end(), servoKeys.begin(), servoKeys.end());
  const Object joints = root.child("joints", "{ JOINT: {kp, kd, armature}, ... }");
  for (const auto& [name, entry] : joints.value.items()) {
    const Object object(entry, "joint " + name.substr(0, 80), "joints." + name.substr(0, 80), file);
    MechanismParts::Joint* part = parts.find(name);
    if (!part) object.fail("the URDF has no joint of this name");
    if (part->fixed) object.fail("is fixed in the URDF; leave it out");
    object.only(jointKeys);
    if (object.has("max_torque")) part->joint.maxTorque = object.number("max_torque", "");
    if (object.has("max_speed")) part->joint.maxSpeed = object.number("max_speed", "");
    readPassive(object, part->joint);
    readEncoder(object, part->joint);
    readDriver(object, *part);
    readServo(object, part->joint.servo);
    readServoType(object, *part);
    part->hasServo = part->isDriven = true;
    part->dampRatio = 0;
  }
  for (MechanismParts::Joint& part : parts.joints) {
    if (part.fixed) continue;
    const MechanismParts::Joint* driver = part.driver.empty() ? nullptr : parts.find(part.driver);
    if (!part.hasServo && driver && driver->hasServo) {
      part.joint.servo = driver->joint.servo;
      part.hasServo = true;
    }
    if (!part.hasServo)
      failMechanism(file, "joint " + part.joint.name + " is missing; give it kp, kd and armature");
    if (!(part.joint.maxTorque > 0) || !(part.joint.maxSpeed > 0))
      failMechanism(
          file, "joint " + part.joint.name +
                    ": max_torque or max_speed is not above 0, here or as effort and velocity in the URDF");
  }
  readRest(root, parts);
}

}  // namespace plumbline
