#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "math/Types.h"
#include "robot/JointId.h"
#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// One cycle: a message and the world it was made from, in this project's axes, signs and units. Poses are of
/// bodies' centres of mass, in the world.
struct TraceRow {
  JointArray command{};    ///< in force after the reply to this message, not clamped [rad/s]
  JointArray angle{};      ///< as in the message, to 0.01 degrees [rad]
  JointArray axisAngle{};  ///< about the axes, from the bodies' orientations, to 0.0001 degrees [rad]
  Vec3 gyro = Vec3::Zero(), acc = Vec3::Zero();  ///< torso frame [rad/s, m/s^2]
  /// Of feet and toes, in the frame of the body's centre of mass; absent when nothing touched.
  std::optional<ForceReading> leftFootForce, rightFootForce, leftToeForce, rightToeForce;
  Pose3 torso = Pose3::Identity(), leftFoot = Pose3::Identity(), rightFoot = Pose3::Identity();
  Vec3 ball = Vec3::Zero();
};

/// A recording of one robot on the league's server, a row per 20 ms.
struct LeagueTrace {
  std::string name;              ///< of the file, without its endings
  std::optional<int> robotType;  ///< from the end of the name, "_t3" or "_r2t3"
  std::optional<int> robot;      ///< 2 of "_r2t3", where the recording has several
  std::vector<JointId> joints;   ///< those the file has columns for
  std::vector<TraceRow> rows;
};

constexpr double traceStep = 0.02;  ///< [s]

/// What a trace's name says: NAME_t3 is of type 3; NAME_r2t3 is robot 2, of type 3, of recording NAME.
struct TraceName {
  std::string name;       ///< the file's without its endings; may hold a dot, as in "v1.5"
  std::string recording;  ///< the name without "_r2t3"
  std::optional<int> robot, type;
};
TraceName traceName(const std::filesystem::path& file);

/// Reads a trace: CSV with a header line, plain or gzip. Other columns than those named above are ignored.
/// Error: std::runtime_error "file:line: what to do" for a missing file or column, a broken or absurdly long
/// file, a line of another length, or what is not a number.
LeagueTrace readLeagueTrace(const std::filesystem::path& file);

}  // namespace plumbline::simspark
