#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "math/Types.h"
#include "simspark/SceneState.h"

namespace plumbline::simspark {

// The compact protocol of bin/simplemonitor (thesis A.6.3): positions alone, sent five times a second. Its
// grammar is in doc/reference/field-protocol.md.

/// A robot seen from above, in metres of the field frame.
struct FieldRobot {
  TeamSide side = TeamSide::none;
  int unum = 0;  ///< 0 without a team
  Vec2 position = Vec2::Zero();
  double heading = 0;   ///< counterclockwise from the direction to the right goal [rad]
  bool fallen = false;  ///< its torso leans by more than 60 degrees
};

/// The content of a field message.
struct FieldState : Scoreboard {
  Vec3 ball = Vec3::Zero();  ///< [m]
  std::vector<FieldRobot> robots;
};

/// Shortest time between two messages [s of real time].
constexpr double fieldInterval = 0.2;
/// Robots a message has at most; more are left out, or are an error for the reader.
constexpr std::size_t maxFieldRobots = 64;
/// Longer names of teams are cut, so that they do not cost more than the positions.
constexpr std::size_t maxFieldTeamName = 20;

FieldState fieldState(const SceneState& scene);

/// At most 720 bytes with 22 robots, without the frame's four.
std::string writeFieldMessage(const FieldState& state);

/// Empty, or one line why the message could not be read; then `state` is untouched.
std::string readFieldMessage(std::string_view message, FieldState& state);

/// Whether a monitor's message is one of these and not SimSpark's.
bool isFieldMessage(std::string_view message);

}  // namespace plumbline::simspark
