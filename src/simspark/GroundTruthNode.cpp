#include "simspark/GroundTruthNode.h"

namespace plumbline::simspark {

namespace {

using Node = SExpressions::Node;

/// The torso's pose; which axes span it is checked at the end of the node.
struct Axes {
  Vec3 up = Vec3::UnitZ(), forward = Vec3::UnitX();
};

void readMyPosition(NodeReader& reader, Node node, Pose3& pose, Axes& axes) {
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "pose") pose.translation().head<2>() = reader.vector(field).head<2>();
    if (name == "up") axes.up = reader.vector(field);
    if (name == "z") pose.translation().z() = reader.number(reader.word(field));
    if (name == "forward") axes.forward = reader.vector(field);
  });
}

/// (B (x y z)): the first number stands where a name would.
Vec3 ballOf(NodeReader& reader, Node node) {
  const Node place = node.at(1);
  if (!place || place.name().empty() || node.at(2) || place.at(3)) {
    reader.fail(node.name(), "'B' has not one list of three numbers behind it");
    return Vec3::Zero();
  }
  const auto [y, z] = reader.words<2>(place);
  return {reader.number(place.name()), reader.number(y), reader.number(z)};
}

void readTruePlayer(NodeReader& reader, Node node, GroundTruth& truth) {
  GroundTruthPlayer& player = truth.players.emplace_back();
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "team") player.team = reader.word(field);
    if (name == "id") player.unum = reader.integer(reader.word(field));
    if (name == "pose") {
      const Vec3 pose = reader.vector(field);
      player.x = pose.x(), player.y = pose.y(), player.heading = pose.z();
    }
  });
}

}  // namespace

void readGroundTruth(NodeReader& reader, Node node, ServerMessage& message) {
  GroundTruth& truth = message.groundTruth.emplace();
  Axes axes;
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "mypos") readMyPosition(reader, field, truth.T_world_torso, axes);
    if (name == "B") truth.ball = ballOf(reader, field);
    if (name == "P") readTruePlayer(reader, field, truth);
  });
  // The axes come rounded: take the up axis as it is and turn forward into the plane square to it.
  const Vec3 up = axes.up.stableNormalized();
  const Vec3 forward = (axes.forward - up * up.dot(axes.forward)).stableNormalized();
  if (up.norm() < 0.5 || forward.norm() < 0.5)
    return reader.fail(node.name(), "the axes of mypos span no frame");
  Mat3 rotation;
  rotation << forward, up.cross(forward), up;
  truth.T_world_torso.linear() = rotation;
}

}  // namespace plumbline::simspark
