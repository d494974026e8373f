#include "simspark/ServerMessageBuilder.h"

#include "math/Angle.h"
#include "simspark/JointNames.h"
#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

namespace {
constexpr std::size_t mostParts = 5;  ///< that the server tells of a player
}

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
  const JointId joint = jointByPerceptor(nodeName_);
  if (joint != noJoint) message.angle[joint] = simsparkName(joint).sign * fromDegrees(nodeAngle_);
}

void ServerMessageBuilder::closeForce() {
  auto& place = nodeName_ == "lf"    ? message.leftFoot
                : nodeName_ == "rf"  ? message.rightFoot
                : nodeName_ == "lf1" ? message.leftToe
                                     : message.rightToe;
  if (nodeName_ == "lf" || nodeName_ == "rf" || nodeName_ == "lf1" || nodeName_ == "rf1") place = reading_;
  reading_ = ForceReading();
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
  if (numPolars_ < 2) polars_[static_cast<std::size_t>(numPolars_)] = place;
  ++numPolars_;
}

void ServerMessageBuilder::closeObject(std::string_view objectName) {
  if (numPolars_ == 1) message.see->objects.push_back({std::string(objectName), polars_[0]});
  numPolars_ = 0;
}

void ServerMessageBuilder::closePart(std::string_view part) {
  if (numPolars_ == 1) {
    auto& parts = player().parts;
    if (parts.empty()) parts.reserve(mostParts);
    parts.push_back({std::string(part), polars_[0]});
  }
  numPolars_ = 0;
}

void ServerMessageBuilder::closeLine() {
  if (numPolars_ == 2) message.see->lines.push_back({polars_[0], polars_[1]});
  numPolars_ = 0;
}

void ServerMessageBuilder::openGroundTruth() {
  message.groundTruth.emplace();
  upAxis_ = Vec3::UnitZ();
  forwardAxis_ = Vec3::UnitX();
}

void ServerMessageBuilder::closeGroundTruth() {
  // The axes come rounded: take the up axis as it is and turn forward into the plane square to it.
  const Vec3 up = upAxis_.stableNormalized();
  const Vec3 forward = (forwardAxis_ - up * up.dot(forwardAxis_)).stableNormalized();
  if (up.norm() < 0.5 || forward.norm() < 0.5) return fail("the axes of mypos span no frame");
  Mat3 rotation;
  rotation << forward, up.cross(forward), up;
  truth().T_world_torso.linear() = rotation;
}

}  // namespace plumbline::simspark
