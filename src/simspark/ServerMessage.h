#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/Types.h"
#include "robot/JointId.h"

namespace plumbline::simspark {

/// A seen point: distance [m], azimuth [rad, + left], elevation [rad, + up], in the head frame.
struct Polar {
  double distance = 0, azimuth = 0, elevation = 0;
  /// Cartesian point in the head frame, x forward, y left, z up [m].
  Vec3 cartesian() const;
};

struct SeenObject {
  std::string name;
  Polar position;
};  ///< F1L.., G1L.., B
struct SeenLine {
  Polar a, b;
};
struct SeenBodyPart {
  std::string name;
  Polar position;
};  ///< head rlowerarm llowerarm rfoot lfoot
struct SeenPlayer {
  std::string team;
  int unum = 0;
  std::vector<SeenBodyPart> parts;
};

struct See {
  std::vector<SeenObject> objects;
  std::vector<SeenPlayer> players;
  std::vector<SeenLine> lines;
};

struct HeardMessage {
  std::string team;
  double time = 0;
  bool self = false;
  double direction = 0;
  std::string text;
};

/// Force sensor reading in the foot (or toe) frame, x forward, y left, z up [m, N].
struct ForceReading {
  Vec3 point = Vec3::Zero(), force = Vec3::Zero();
};

/// The true state of one player and the ball (extension of A.6.4).
struct GroundTruthPlayer {
  std::string team;
  int unum = 0;
  double x = 0, y = 0, heading = 0;
};
struct GroundTruth {
  Pose3 T_world_torso = Pose3::Identity();
  Vec3 ball = Vec3::Zero();
  std::vector<GroundTruthPlayer> players;
};

struct GameState {
  std::optional<int> unum;          ///< only in the first message after init
  std::optional<std::string> side;  ///< "left" | "right", likewise
  int scoreLeft = 0, scoreRight = 0;
  double time = 0;  ///< [s]
  std::string playMode;
};

/// One message of the server to an agent, converted to this project's axes, signs and units (x forward, y
/// left, rad, m, s); the s-expression's own order and names are kept by the writer.
struct ServerMessage {
  double time = 0;  ///< server clock [s]
  GameState gameState;
  Vec3 gyro = Vec3::Zero();                                    ///< [rad/s], torso frame
  Vec3 acc = Vec3::Zero();                                     ///< [m/s^2], torso frame
  std::array<std::optional<double>, numHumanoidJoints> angle;  ///< [rad]
  std::optional<ForceReading> leftFoot, rightFoot, leftToe, rightToe;
  std::optional<See> see;  ///< every third cycle
  std::vector<HeardMessage> heard;
  std::optional<GroundTruth> groundTruth;
};

}  // namespace plumbline::simspark
