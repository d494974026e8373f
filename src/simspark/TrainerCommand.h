#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "math/Types.h"
#include "simspark/PlayMode.h"
#include "simspark/SExpression.h"
#include "simspark/TeamSide.h"

namespace plumbline::simspark {

// What a trainer may name; a command with a number beyond is refused whole.
constexpr double maxPlace = 1000;     ///< of a coordinate [m]
constexpr double maxBallSpeed = 100;  ///< of a coordinate [m/s]
constexpr double maxTurn = 3600;      ///< of a heading [degrees]
constexpr double maxGameTime = 1e6;   ///< [s]
constexpr int maxScore = 9999;

/// A player as a trainer names it.
struct PlayerName {
  int unum = 0;
  TeamSide side = TeamSide::none;
};

// What a trainer may send to the monitor port, in metres, seconds and radians of the field frame.
/// Teleport. heading [rad, 0: towards the right goal] also turns the robot upright; without it the robot
/// keeps its orientation. Without a player: takes selected players off the selection.
struct MoveAgentCommand {
  std::optional<PlayerName> player;
  std::optional<Vec3> position;
  std::optional<double> heading;
};
struct BallCommand {
  std::optional<Vec3> position, velocity;  ///< a velocity zeroes the spin
};
struct PlayModeCommand {
  PlayMode mode;
};
struct KickOffCommand {
  TeamSide side;
};  ///< none: the simulator chooses
struct DropBallCommand {};
struct TimeCommand {
  double time;
};
struct ScoreCommand {
  int left, right;
};
/// clear: nobody; no player: the next one.
struct SelectCommand {
  std::optional<PlayerName> player;
  bool clear = false;
};
struct KillCommand {
  std::optional<PlayerName> player;
};  ///< no player: the selected one
struct RepositionCommand {
  std::optional<PlayerName> player;
};  ///< beside the field; likewise
struct FullStateCommand {};
struct AcknowledgeCommand {};  ///< (getAck): answered by the message "best"
struct KillSimulatorCommand {};

// The embedded simulator's own; the league's server logs them as unknown and goes on.
/// (clock): from now on send the clock whenever it changes; (pause), (resume), (step N): so many cycles
/// though it is paused; (speed X): so many times real time, 0: as fast as it goes.
struct ClockCommand {
  enum class Kind { subscribe, pause, resume, step, speed };
  Kind kind = Kind::subscribe;
  double value = 1;  ///< of step and speed
};
/// (viewer S): this connection only looks. It gets the state at most every S seconds of real time, however
/// fast the simulation runs, and nothing while it has not read what came before.
struct ViewerCommand {
  double interval = 0.03;
};

/// (reset), (reset SEED): everything from the start, without a new process: time, game, chance, and every
/// robot that is there, in its team.
struct ResetCommand {
  std::optional<std::uint64_t> seed;  ///< none: the one there was
};

using TrainerCommand =
    std::variant<MoveAgentCommand, BallCommand, PlayModeCommand, KickOffCommand, DropBallCommand, TimeCommand,
                 ScoreCommand, SelectCommand, KillCommand, RepositionCommand, FullStateCommand,
                 AcknowledgeCommand, KillSimulatorCommand, ClockCommand, ViewerCommand, ResetCommand>;

/// How the embedded simulator's clock goes: "(clock (paused 0)(speed 1))".
struct SimulatorClock {
  bool paused = false;
  double speed = 1;  ///< times real time; 0: as fast as it goes
  bool operator==(const SimulatorClock&) const = default;
};
constexpr double minSpeed = 0.05, maxSpeed = 1000;
constexpr int maxSteps = 1000000;
std::string writeClock(const SimulatorClock& clock);
std::optional<SimulatorClock> readClock(std::string_view message);

std::string writeTrainerCommand(const TrainerCommand& command);

class TrainerCommandParser {
public:
  /// Appends the commands of a message. The return value is empty or one line about the first part that is no
  /// command; it is skipped.
  std::string parse(std::string_view text, std::vector<TrainerCommand>& commands);

  /// Whether the last text was a list of s-expressions at all.
  bool wellFormed() const { return wellFormed_; }

private:
  bool wellFormed_ = true;
  SExpressions expressions_{{.depth = 8, .nodes = 4096}};
};

}  // namespace plumbline::simspark
