#include "simspark/ServerMessageBuilder.h"

#include "math/Angle.h"
#include "simspark/JointNames.h"
#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

Vec3 Polar::cartesian() const {
  return distance * Vec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
}

void ServerMessageBuilder::fail(const char* what) {
  if (!error) error = ParseError{wordStart, what};
}

void ServerMessageBuilder::fail(std::string_view word, const char* what) {
  if (error) return;
  error =
      ParseError{static_cast<std::size_t>(word.data() - text), "'" + std::string(word.substr(0, 20)) + what};
}

double ServerMessageBuilder::number(std::string_view word) {
  const auto value = parseNumber(word);
  if (!value) fail(word, "' is no number");
  return value.value_or(0);
}

int ServerMessageBuilder::integer(std::string_view word) {
  const auto value = parseInteger(word);
  if (!value) fail(word, "' is no whole number");
  return value.value_or(0);
}

void ServerMessageBuilder::closeHingeJoint() {
  const JointId joint = jointByPerceptor(nodeName);
  if (joint != noJoint) message.angle[joint] = simsparkName(joint).sign * fromDegrees(nodeAngle);
}

void ServerMessageBuilder::closeForce() {
  auto& place = nodeName == "lf"    ? message.leftFoot
                : nodeName == "rf"  ? message.rightFoot
                : nodeName == "lf1" ? message.leftToe
                                    : message.rightToe;
  if (nodeName == "lf" || nodeName == "rf" || nodeName == "lf1" || nodeName == "rf1") place = reading;
  reading = ForceReading();
}

void ServerMessageBuilder::hear(std::string_view team, std::string_view time, std::string_view direction,
                                std::string_view text) {
  HeardMessage heard;
  heard.team = team;
  heard.time = number(time);
  heard.self = direction == "self";
  if (!heard.self) heard.direction = fromDegrees(number(direction));
  heard.text = text;
  message.heard.push_back(std::move(heard));
}

void ServerMessageBuilder::polar(std::string_view distance, std::string_view azimuth,
                                 std::string_view elevation) {
  for (const std::string_view word : {distance, azimuth, elevation})
    if (word == "nan" || word == "-nan") return;
  const Polar place{number(distance), fromDegrees(number(azimuth)), fromDegrees(number(elevation))};
  if (numPolars < 2) polars[static_cast<std::size_t>(numPolars)] = place;
  ++numPolars;
}

void ServerMessageBuilder::closeObject(std::string_view objectName) {
  if (numPolars == 1) message.see->objects.push_back({std::string(objectName), polars[0]});
  numPolars = 0;
}

void ServerMessageBuilder::closePart(std::string_view part) {
  if (numPolars == 1) player().parts.push_back({std::string(part), polars[0]});
  numPolars = 0;
}

void ServerMessageBuilder::closeLine() {
  if (numPolars == 2) message.see->lines.push_back({polars[0], polars[1]});
  numPolars = 0;
}

void ServerMessageBuilder::openGroundTruth() {
  message.groundTruth.emplace();
  upAxis = Vec3::UnitZ();
  forwardAxis = Vec3::UnitX();
}

void ServerMessageBuilder::closeGroundTruth() {
  // The axes come rounded: take the up axis as it is and turn forward into the plane square to it.
  const Vec3 up = upAxis.stableNormalized();
  const Vec3 forward = (forwardAxis - up * up.dot(forwardAxis)).stableNormalized();
  if (up.norm() < 0.5 || forward.norm() < 0.5) return fail("the axes of mypos span no frame");
  Mat3 rotation;
  rotation << forward, up.cross(forward), up;
  truth().T_world_torso.linear() = rotation;
}

}  // namespace plumbline::simspark
