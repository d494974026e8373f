#include "simspark/SenseNodes.h"

#include "math/Angle.h"
#include "simspark/JointNames.h"

namespace plumbline::simspark {

namespace {

using Node = SExpressions::Node;

/// SimSpark's torso has x to the right and y forward.
Vec3 fromSimspark(const Vec3& v) { return {v.y(), -v.x(), v.z()}; }

/// The place of a force sensor's reading, or null for one that is not known.
std::optional<ForceReading>* placeOf(std::string_view sensor, ServerMessage& message) {
  if (sensor == "lf") return &message.leftFoot;
  if (sensor == "rf") return &message.rightFoot;
  if (sensor == "lf1") return &message.leftToe;
  if (sensor == "rf1") return &message.rightToe;
  return nullptr;
}

}  // namespace

void readTime(NodeReader& reader, Node node, ServerMessage& message) {
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "now") message.time = reader.number(reader.word(field));
  });
}

void readGameState(NodeReader& reader, Node node, ServerMessage& message) {
  GameState& state = message.gameState;
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "t") state.time = reader.number(reader.word(field));
    if (name == "pm") state.playMode = reader.word(field);
    if (name == "sl") state.scoreLeft = reader.integer(reader.word(field));
    if (name == "sr") state.scoreRight = reader.integer(reader.word(field));
    if (name == "unum") state.unum = reader.integer(reader.word(field));
    if (name == "team") state.side = std::string(reader.word(field));
  });
}

void readGyro(NodeReader& reader, Node node, ServerMessage& message) {
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "rt") message.gyro = fromSimspark(reader.vector(field).unaryExpr(&fromDegrees));
  });
}

void readAcceleration(NodeReader& reader, Node node, ServerMessage& message) {
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "a") message.acc = fromSimspark(reader.vector(field));
  });
}

void readHingeJoint(NodeReader& reader, Node node, ServerMessage& message) {
  std::string_view sensor;
  std::optional<double> degrees;
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "n") sensor = reader.word(field);
    if (name == "ax") degrees = reader.number(reader.word(field));
  });
  const JointId joint = jointByPerceptor(sensor);
  if (joint != noJoint && degrees && !reader.failed())
    message.angle[joint] = simsparkName(joint).sign * fromDegrees(*degrees);
}

void readForce(NodeReader& reader, Node node, ServerMessage& message) {
  std::string_view sensor;
  ForceReading reading;
  bool hasForce = false;
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "n") sensor = reader.word(field);
    if (name == "c") reading.point = fromSimspark(reader.vector(field));
    if (name == "f") reading.force = fromSimspark(reader.vector(field)), hasForce = true;
  });
  if (!hasForce || reader.failed()) return;
  if (std::optional<ForceReading>* place = placeOf(sensor, message)) *place = reading;
}

void readHeard(NodeReader& reader, Node node, ServerMessage& message) {
  const bool namesTeam = static_cast<bool>(node.at(4));
  std::string_view team, time, direction, text;
  if (namesTeam) {
    const auto words = reader.words<4>(node);
    team = words[0], time = words[1], direction = words[2], text = words[3];
  } else {
    const auto words = reader.words<3>(node);
    time = words[0], direction = words[1], text = words[2];
  }
  HeardMessage heard;
  heard.team = team;
  heard.time = reader.number(time);
  heard.self = direction == "self";
  if (!heard.self) heard.direction = fromDegrees(reader.number(direction));
  heard.text = text;
  if (!reader.failed()) message.heard.push_back(std::move(heard));
}

}  // namespace plumbline::simspark
