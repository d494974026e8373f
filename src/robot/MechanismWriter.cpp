#include "robot/MechanismWriter.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace plumbline {
namespace {

using nlohmann::ordered_json;

constexpr double leastMass = 1e-6;  ///< [kg]

ordered_json listOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

ordered_json shapeJson(const Shape& shape) {
  ordered_json json;
  switch (shape.kind) {
    case Shape::Kind::box:
      json["box"] = listOf(shape.size);
      break;
    case Shape::Kind::sphere:
      json["sphere"] = shape.size.x();
      break;
    case Shape::Kind::capsule:
      json["capsule"] = {shape.size.x(), shape.size.z()};
      break;
  }
  json["centre"] = listOf(shape.T_link_shape.translation());
  json["rpy"] = listOf(rpyOfRotation(shape.T_link_shape.linear()));
  return json;
}

ordered_json linkJson(const Mechanism::Link& link) {
  const Mat3& i = link.inertia;
  ordered_json json = {{"mass", link.mass},
                       {"com", listOf(link.com)},
                       {"inertia", {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)}}};
  if (link.shape) json["shape"] = shapeJson(*link.shape);
  if (link.collides) json["collides"] = true;
  return json;
}

ordered_json servoJson(const Servo& servo) {
  ordered_json json = {{"kp", servo.kp}, {"kd", servo.kd}, {"armature", servo.armature}};
  if (!(servo.kp > 0)) json["model"] = "torque";
  if (servo.model == Servo::Model::dcMotor) json["model"] = "dc_motor";
  if (!(servo.R > 0)) return json;  // a servo with the linear law may have its motor's numbers, too
  json["dc_motor"] = {{"kt", servo.kt},
                      {"R", servo.R},
                      {"vin", servo.vin},
                      {"error_gain", servo.errorGain},
                      {"kp_firmware", servo.kpFirmware},
                      {"max_pwm", servo.maxPwm}};
  return json;
}

ordered_json jointJson(const Mechanism& robot, const Mechanism::Joint& joint) {
  const auto link = [&](int index) { return robot.links[static_cast<std::size_t>(index)].name; };
  ordered_json json = {{"name", joint.name}};
  if (joint.type == Mechanism::Joint::Type::prismatic) json["type"] = "prismatic";
  json["parent"] = link(joint.parent);
  json["child"] = link(joint.child);
  json["origin"] = listOf(joint.origin);
  json["rpy"] = listOf(joint.rpy);
  json["axis"] = listOf(joint.axis);
  json["lower"] = joint.lower;
  json["upper"] = joint.upper;
  json["max_torque"] = joint.maxTorque;
  json["max_speed"] = joint.maxSpeed;
  if (joint.encoder == Mechanism::Joint::Encoder::link) json["encoder"] = "link";
  if (joint.driver >= 0) {
    json["driven_by"] = robot.joints[static_cast<std::size_t>(joint.driver)].name;
    json["driver_ratio"] = joint.driverRatio;
    json["driver_offset"] = joint.driverOffset;
  }
  if (joint.friction > 0) json["friction"] = joint.friction;
  if (joint.damping > 0) json["damping"] = joint.damping;
  json["servo"] = servoJson(joint.servo);
  return json;
}

void addSensors(const Mechanism& robot, ordered_json& json) {
  if (robot.hasImu)
    json["imu"] = {{"link", robot.links[static_cast<std::size_t>(robot.imu.link)].name},
                   {"gyro", listOf(robot.imu.gyro)},
                   {"accelerometer", listOf(robot.imu.accelerometer)},
                   {"rpy", listOf(robot.imu.rpy)}};
  for (const Mechanism::Foot& foot : robot.feet) {
    json["feet"].push_back({{"name", foot.name},
                            {"link", robot.links[static_cast<std::size_t>(foot.link)].name},
                            {"sole_centre", listOf(foot.soleCentre)},
                            {"sole_size", listOf(foot.soleSize)}});
    for (const Mechanism::ForceSensor& sensor : foot.sensors)
      json["fsr"][foot.name + "." + sensor.corner] = listOf(sensor.position);
  }
}

}  // namespace

std::string mechanismText(const Mechanism& robot) {
  ordered_json json = {{"name", robot.name},
                       {"base_link", robot.links.front().name},
                       {"gravity", listOf(robot.gravity)},
                       {"rates", {{"control_hz", robot.controlHz}}}};
  for (const Mechanism::Link& link : robot.links) json["links"][link.name] = linkJson(link);
  // A URDF's root may have no mass; a link of this form needs one.
  ordered_json& base = json["links"][robot.links.front().name]["mass"];
  base = std::max(leastMass, base.get<double>());
  json["joints"] = ordered_json::array();
  for (const Mechanism::Joint& joint : robot.joints) json["joints"].push_back(jointJson(robot, joint));
  addSensors(robot, json);
  for (const Mechanism::Group& group : robot.groups)
    for (const int joint : group.joints)
      json["groups"][group.name].push_back(robot.joints[static_cast<std::size_t>(joint)].name);
  return json.dump(1) + "\n";
}

}  // namespace plumbline
