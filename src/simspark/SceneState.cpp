#include "simspark/SceneState.h"

#include <cmath>
#include <stdexcept>

#include "simspark/FieldWords.h"
#include "simspark/LeagueRobots.h"
#include "simspark/MeshNames.h"
#include "simspark/NumberFormat.h"
#include "simspark/WordNumbers.h"

namespace plumbline::simspark {

using Word = SExpressions::Node;
using Eigen::Matrix4d;

namespace {

constexpr Range fieldSizeRange(0.001, 1000);  ///< of any size of a field [m]

/// Type, number and side from "models/naobody3.obj" and "matNum7 matLeft ...".
SceneRobot robotFrom(const std::string& mesh, const std::vector<std::string>& materials) {
  SceneRobot robot;
  const char digit = mesh.size() > bodyMesh.size() ? mesh[bodyMesh.size()] : '0';
  robot.type = digit >= '0' && digit <= '9' ? digit - '0' : 0;
  for (const std::string& material : materials) {
    if (material.starts_with("matNum"))
      robot.unum = parseInteger(std::string_view(material).substr(6)).value_or(0);
    if (material == "matLeft") robot.side = TeamSide::left;
    if (material == "matRight") robot.side = TeamSide::right;
  }
  return robot;
}

/// A size that no field can have is not believed.
void readFieldWord(std::string_view name, std::string_view value, FieldSize& field) {
  const auto take = [&](const FieldWord& word) {
    const auto number = name == word.name ? parseNumber(value) : std::nullopt;
    if (number && fieldSizeRange.contains(*number)) field.*word.size = *number;
  };
  for (const FieldWord& word : leagueFieldWords) take(word);
  for (const FieldWord& word : ownFieldWords) take(word);
}

}  // namespace

Pose3 sceneRobotPose(const Matrix4d& matrix) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = matrix.block<3, 1>(0, 3);
  Mat3 axes;
  axes << matrix.block<3, 1>(0, 1), -matrix.block<3, 1>(0, 0), matrix.block<3, 1>(0, 2);
  pose.linear() = axes;
  return pose;
}

double SceneRobot::heading() const {
  const Vec3 forward = T_world_torso.linear().col(0);
  return std::atan2(forward.y(), forward.x());
}

std::vector<std::string> sceneBodies(int type) {
  const bool toes = simsparkRobot(type).has(lToePitch);
  std::vector<std::string> names = {"torso", "neck", "head"};
  for (const std::string side : {"r", "l"})
    for (const char* body : {"Shoulder", "UpperArm", "Elbow", "LowerArm"}) names.push_back(side + body);
  for (const std::string side : {"r", "l"}) {
    for (const char* body : {"Hip1", "Hip2", "Thigh", "Shank", "Ankle", "Foot"}) names.push_back(side + body);
    if (toes) names.push_back(side + "Toe");
  }
  return names;
}

const SceneRobot* SceneState::robot(TeamSide side, int unum) const {
  for (const SceneRobot& r : robots)
    if (r.side == side && r.unum == unum) return &r;
  return nullptr;
}

bool SceneState::readMatrix(Word list, Matrix4d& matrix) {
  Word word = list.first();
  Matrix4d read;
  for (int i = 0; i < 16; ++i) {
    word = word ? word.next() : word;
    const auto value = parseNumber(wordOf(word));
    if (!value) return false;
    read(i % 4, i / 4) = *value;
  }
  matrix = read;
  return true;
}

bool SceneState::readNode(Word list, Node& node) {
  node.transform = wordOf(list.at(1)) == "TRF";
  for (Word part = list.first(); part; part = part.next()) {
    const std::string_view name = part.name();
    if (name == "SLT" && !readMatrix(part, node.matrix)) return false;
    if (name == "load") node.mesh = wordOf(part.at(1));
    if (name == "resetMaterials")
      for (Word word = part.at(1); word; word = word.next()) node.materials.emplace_back(wordOf(word));
    if (name == "nd" && !readNode(part, node.children.emplace_back())) return false;
  }
  return true;
}

bool SceneState::updateNode(Word list, Node& node) {
  std::size_t child = 0;
  for (Word part = list.first(); part; part = part.next()) {
    const std::string_view name = part.name();
    if (name == "SLT" && !readMatrix(part, node.matrix)) return false;
    if (name == "nd" && (child >= node.children.size() || !updateNode(part, node.children[child++])))
      return false;
  }
  return child == node.children.size();
}

void SceneState::gameState(Word list) {
  fouls.clear();
  for (Word part = list.first(); part; part = part.next()) {
    const std::string_view name = part.name(), value = wordOf(part.at(1));
    readFieldWord(name, value, field);
    if (name == "time") time = parseNumber(value).value_or(time);
    if (name == "foul")
      if (const auto foul = readFoul(part)) fouls.push_back(*foul);
    if (name == "half") half = parseInteger(value).value_or(half);
    if (name == "score_left") scoreLeft = parseInteger(value).value_or(scoreLeft);
    if (name == "score_right") scoreRight = parseInteger(value).value_or(scoreRight);
    if (name == "team_left") teamLeft = value;
    if (name == "team_right") teamRight = value;
    if (name == "play_modes") {
      modeNames_.clear();
      for (Word mode = part.at(1); mode; mode = mode.next()) modeNames_.emplace_back(wordOf(mode));
    }
    if (name == "play_mode")
      if (const auto index = parseInteger(value);
          index && *index >= 0 && *index < static_cast<int>(modeNames_.size()))
        playMode = modeNames_[static_cast<std::size_t>(*index)];
  }
}

/// Meshes hang in the transform of their body, or one deeper in a transform that only turns them.
void SceneState::find(const Node& node, const Matrix4d& T_world_parent, const Matrix4d& T_world_node) {
  if (node.mesh.starts_with(bodyMesh)) {
    SceneRobot robot = robotFrom(node.mesh, node.materials);
    robot.T_world_torso = sceneRobotPose(T_world_parent);
    robots.push_back(robot);
  } else if (node.mesh == ballMesh) {
    ball = T_world_node.block<3, 1>(0, 3);
    ballAxes = T_world_node.block<3, 3>(0, 0);
  }
  for (const Node& child : node.children) {
    if (child.transform)
      find(child, T_world_node, T_world_node * child.matrix);
    else
      find(child, T_world_parent, T_world_node);
  }
}

/// A robot is a node of the scene with a transform for each of its bodies.
void SceneState::addBodies(const Node& robotNode, std::size_t firstRobot) {
  if (robots.size() != firstRobot + 1) return;
  for (const Node& body : robotNode.children)
    if (body.transform)
      robots.back().T_world_bodies.push_back(sceneRobotPose(robotNode.matrix * body.matrix));
}

std::string SceneState::update(std::string_view message) {
  if (!expressions_.parse(message))
    return expressions_.error() + " at byte " + std::to_string(expressions_.errorPosition());
  const Word state = expressions_.first();
  if (!state || !state.isList()) return "no list of game state";
  gameState(state);
  const Word header = state.next();
  if (!header) return {};
  const Word scene = header.next();
  if (!scene || !scene.isList()) return "no scene";
  if (header.name() == "RSG") {
    std::vector<Node> read;
    for (Word part = scene.first(); part; part = part.next())
      if (part.name() == "nd" && !readNode(part, read.emplace_back()))
        return "a transform without 16 numbers";
    nodes_ = std::move(read);
  } else if (header.name() == "RDS") {
    if (!complete()) return "a difference before a whole scene";
    std::size_t i = 0;
    for (Word part = scene.first(); part; part = part.next())
      if (part.name() == "nd" && (i >= nodes_.size() || !updateNode(part, nodes_[i++])))
        return "a difference to another scene";
  } else {
    return "neither a scene nor a difference";
  }
  robots.clear();
  for (const Node& node : nodes_) {
    const std::size_t before = robots.size();
    find(node, Matrix4d::Identity(), node.matrix);
    addBodies(node, before);
  }
  return {};
}

}  // namespace plumbline::simspark
