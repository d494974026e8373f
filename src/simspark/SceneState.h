#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "field/FieldSize.h"
#include "math/Types.h"
#include "simspark/PlayMode.h"
#include "simspark/SExpression.h"
#include "simspark/SceneFoul.h"
#include "simspark/TeamSide.h"

namespace plumbline::simspark {

/// A robot as the monitor's scene shows it.
struct SceneRobot {
  TeamSide side = TeamSide::none;
  int unum = 0;  ///< 0 without a team
  int type = 0;
  /// This project's axes: x forward, y left, z up; a difference has it only when it moved by more than 5 mm
  /// or 0.3 degrees.
  Pose3 T_world_torso = Pose3::Identity();
  /// All its bodies in the scene's order, see sceneBodies(); the first is the torso.
  std::vector<Pose3> T_world_bodies;

  /// Counterclockwise from the direction to the right goal [rad].
  double heading() const;
};

/// A body's transform in SimSpark's axes, which for robots are x to the right and y forward, as a pose in
/// ours.
Pose3 sceneRobotPose(const Eigen::Matrix4d& matrix);

/// Names of the links of simsparkRobot(type) whose bodies the scene holds, in its order: the same on the
/// league's server and here. Throws ConfigurationError for a type that is not there.
std::vector<std::string> sceneBodies(int type);

/// What a scoreboard shows, and the field.
struct Scoreboard {
  double time = 0;  ///< game clock [s]
  int half = 0, scoreLeft = 0, scoreRight = 0;
  std::string playMode, teamLeft, teamRight;
  FieldSize field;  ///< the league's, but for what the simulator sends
};

/// The state of the game as it reaches a monitor; fed with the monitor port's messages, whole scenes and
/// differences.
class SceneState : public Scoreboard {
public:
  /// Empty, or one line why the message could not be read; then what was not read stays as it was.
  std::string update(std::string_view message);

  bool complete() const { return !nodes_.empty(); }  ///< a whole scene has come
  Vec3 ball = Vec3::Zero();
  Mat3 ballAxes = Mat3::Identity();
  std::vector<SceneRobot> robots;
  std::vector<SceneFoul> fouls;  ///< those of the last message

  const SceneRobot* robot(TeamSide side, int unum) const;

private:
  struct Node {
    bool transform = false;
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    std::string mesh;  ///< of a drawn node: its file
    std::vector<std::string> materials;
    std::vector<Node> children;
  };

  void gameState(SExpressions::Node list);
  static bool readNode(SExpressions::Node list, Node& node);
  static bool updateNode(SExpressions::Node list, Node& node);
  static bool readMatrix(SExpressions::Node list, Eigen::Matrix4d& matrix);
  void find(const Node& node, const Eigen::Matrix4d& T_world_parent, const Eigen::Matrix4d& T_world_node);
  void addBodies(const Node& robotNode, std::size_t firstRobot);

  SExpressions expressions_;
  std::vector<std::string> modeNames_;
  std::vector<Node> nodes_;
};

}  // namespace plumbline::simspark
