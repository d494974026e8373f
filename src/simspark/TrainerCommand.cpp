#include "simspark/TrainerCommand.h"

#include <array>
#include <cmath>
#include <initializer_list>

#include "math/Angle.h"
#include "simspark/NumberFormat.h"
#include "simspark/WordNumbers.h"

namespace plumbline::simspark {

namespace {

using Node = SExpressions::Node;
constexpr int trainerDecimals = 6;

// ---- reading
// -----------------------------------------------------------------------------------------------

/// The numbers behind the list's name; false if one is missing or beyond +-most.
template <std::size_t n>
bool numbers(Node list, std::array<double, n>& values, double most) {
  for (std::size_t i = 0; i < n; ++i) {
    const auto value = numberOf(list.at(static_cast<int>(i) + 1));
    if (!value || std::abs(*value) > most) return false;
    values[i] = *value;
  }
  return true;
}

std::optional<TeamSide> sideByName(std::string_view name) {
  if (name == "Left") return TeamSide::left;
  if (name == "Right") return TeamSide::right;
  if (name == "None") return TeamSide::none;
  return std::nullopt;
}

std::optional<PlayerName> player(Node list) {
  const auto unum = integerOf(list.list("unum").at(1));
  const auto side = sideByName(wordOf(list.list("team").at(1)));
  if (!unum || !side) return std::nullopt;
  return PlayerName{*unum, *side};
}

std::optional<TrainerCommand> readAgent(Node list) {
  MoveAgentCommand command;
  command.player = player(list);
  if (const Node position = list.list("pos")) {
    std::array<double, 3> p;
    if (!numbers(position, p, maxPlace)) return std::nullopt;
    command.position = Vec3(p[0], p[1], p[2]);
  }
  if (const Node move = list.list("move")) {
    std::array<double, 4> p;
    if (!numbers(move, p, maxTurn) || std::abs(p[0]) > maxPlace || std::abs(p[1]) > maxPlace ||
        std::abs(p[2]) > maxPlace)
      return std::nullopt;
    command.position = Vec3(p[0], p[1], p[2]);
    command.heading = fromDegrees(p[3]) + pi / 2;  // SimSpark's robots look along y at 0
  }
  return command;
}

std::optional<TrainerCommand> readBall(Node list) {
  BallCommand command;
  struct Field {
    const char* name;
    std::optional<Vec3>* value;
    double most;
  };
  for (const auto& [name, place, most] :
       {Field{"pos", &command.position, maxPlace}, Field{"vel", &command.velocity, maxBallSpeed}}) {
    const Node field = list.list(name);
    if (!field) continue;
    std::array<double, 3> p;
    if (!numbers(field, p, most)) return std::nullopt;
    *place = Vec3(p[0], p[1], p[2]);
  }
  return command;
}

std::optional<TrainerCommand> readScore(Node list) {
  const auto left = integerOf(list.list("left").at(1)), right = integerOf(list.list("right").at(1));
  if (!left || !right || *left < 0 || *right < 0 || *left > maxScore || *right > maxScore)
    return std::nullopt;
  return ScoreCommand{*left, *right};
}

std::optional<TrainerCommand> readClockCommand(Node list, std::string_view name) {
  using Kind = ClockCommand::Kind;
  if (name == "clock") return ClockCommand{Kind::subscribe};
  if (name == "pause") return ClockCommand{Kind::pause};
  if (name == "resume") return ClockCommand{Kind::resume};
  if (name == "step" && !list.at(1)) return ClockCommand{Kind::step};
  if (name == "step") {
    const auto steps = integerOf(list.at(1));
    if (steps && *steps > 0 && *steps <= maxSteps)
      return ClockCommand{Kind::step, static_cast<double>(*steps)};
  }
  if (name == "speed") {
    const auto speed = numberOf(list.at(1));
    if (speed && (*speed == 0 || (*speed >= minSpeed && *speed <= maxSpeed)))
      return ClockCommand{Kind::speed, *speed};
  }
  return std::nullopt;
}

/// Whole numbers a double holds exactly.
constexpr double maxSeed = 0x1p53;

std::optional<TrainerCommand> readReset(Node list) {
  if (!list.at(1)) return ResetCommand{};
  const auto seed = numberOf(list.at(1));
  if (!seed || *seed < 0 || *seed > maxSeed || *seed != std::floor(*seed)) return std::nullopt;
  return ResetCommand{static_cast<std::uint64_t>(*seed)};
}

std::optional<TrainerCommand> readOne(Node list) {
  const std::string_view name = list.name();
  if (name.empty()) return std::nullopt;
  if (name == "agent") return readAgent(list);
  if (name == "ball") return readBall(list);
  if (name == "score") return readScore(list);
  if (name == "dropBall") return DropBallCommand{};
  if (name == "reqfullstate") return FullStateCommand{};
  if (name == "getAck") return AcknowledgeCommand{};
  if (name == "killsim") return KillSimulatorCommand{};
  if (name == "kill") return KillCommand{player(list)};
  if (name == "repos") return RepositionCommand{player(list)};
  if (name == "select") {
    return SelectCommand{player(list), integerOf(list.list("unum").at(1)) == -1};
  }
  if (name == "playMode") {
    const auto mode = playModeByName(wordOf(list.at(1)));
    return mode ? std::optional<TrainerCommand>(PlayModeCommand{*mode}) : std::nullopt;
  }
  if (name == "kickOff") {
    const auto side = sideByName(wordOf(list.at(1)));
    return side ? std::optional<TrainerCommand>(KickOffCommand{*side}) : std::nullopt;
  }
  if (name == "reset") return readReset(list);
  if (name == "viewer") {
    const auto interval = numberOf(list.at(1));
    return interval && *interval >= 0.001 && *interval <= 60
               ? std::optional<TrainerCommand>(ViewerCommand{*interval})
               : std::nullopt;
  }
  if (auto command = readClockCommand(list, name)) return command;
  if (name == "time") {
    const auto time = numberOf(list.at(1));
    return time && *time >= 0 && *time <= maxGameTime ? std::optional<TrainerCommand>(TimeCommand{*time})
                                                      : std::nullopt;
  }
  return std::nullopt;
}

// ---- writing
// -----------------------------------------------------------------------------------------------

std::string fixed(double value) {
  std::string text;
  appendFixed(text, value, trainerDecimals);
  return text;
}

std::string vector(const char* name, const Vec3& v) {
  return std::string("(") + name + ' ' + fixed(v.x()) + ' ' + fixed(v.y()) + ' ' + fixed(v.z()) + ')';
}

const char* trainerName(TeamSide side) {
  return side == TeamSide::left ? "Left" : side == TeamSide::right ? "Right" : "None";
}

std::string playerText(const std::optional<PlayerName>& name) {
  if (!name) return "";
  return "(unum " + std::to_string(name->unum) + ")(team " + trainerName(name->side) + ')';
}

struct CommandWriter {
  std::string operator()(const MoveAgentCommand& c) const {
    std::string text = "(agent " + playerText(c.player);
    if (c.position && c.heading) {
      const std::string place = vector("move", *c.position);
      text += place.substr(0, place.size() - 1) + ' ' +
              fixed(toDegrees(normalizeAngle(*c.heading - pi / 2))) + ')';
    } else if (c.position) {
      text += vector("pos", *c.position);
    }
    return text + ')';
  }
  std::string operator()(const BallCommand& c) const {
    return "(ball " + (c.position ? vector("pos", *c.position) : "") +
           (c.velocity ? vector("vel", *c.velocity) : "") + ')';
  }
  std::string operator()(const PlayModeCommand& c) const {
    return "(playMode " + std::string(playModeName(c.mode)) + ')';
  }
  std::string operator()(const KickOffCommand& c) const {
    return std::string("(kickOff ") + trainerName(c.side) + ')';
  }
  std::string operator()(const DropBallCommand&) const { return "(dropBall)"; }
  std::string operator()(const TimeCommand& c) const { return "(time " + fixed(c.time) + ')'; }
  std::string operator()(const ScoreCommand& c) const {
    return "(score (left " + std::to_string(c.left) + ")(right " + std::to_string(c.right) + "))";
  }
  std::string operator()(const SelectCommand& c) const {
    return "(select " + (c.clear ? "(unum -1)" : playerText(c.player)) + ')';
  }
  std::string operator()(const KillCommand& c) const { return "(kill " + playerText(c.player) + ')'; }
  std::string operator()(const RepositionCommand& c) const { return "(repos " + playerText(c.player) + ')'; }
  std::string operator()(const FullStateCommand&) const { return "(reqfullstate)"; }
  std::string operator()(const AcknowledgeCommand&) const { return "(getAck)"; }
  std::string operator()(const KillSimulatorCommand&) const { return "(killsim)"; }
  std::string operator()(const ClockCommand& c) const {
    switch (c.kind) {
      case ClockCommand::Kind::subscribe:
        return "(clock)";
      case ClockCommand::Kind::pause:
        return "(pause)";
      case ClockCommand::Kind::resume:
        return "(resume)";
      case ClockCommand::Kind::step:
        return "(step " + std::to_string(static_cast<int>(c.value)) + ')';
      case ClockCommand::Kind::speed:
        break;
    }
    return "(speed " + fixed(c.value) + ')';
  }
  std::string operator()(const ResetCommand& c) const {
    return c.seed ? "(reset " + std::to_string(*c.seed) + ')' : "(reset)";
  }
  std::string operator()(const ViewerCommand& c) const { return "(viewer " + fixed(c.interval) + ')'; }
};

}  // namespace

std::string writeTrainerCommand(const TrainerCommand& command) {
  return std::visit(CommandWriter(), command);
}

std::string writeClock(const SimulatorClock& clock) {
  std::string text = "(clock (paused ";
  text += clock.paused ? '1' : '0';
  text += ")(speed ";
  appendGeneral(text, static_cast<float>(clock.speed));
  return text + "))";
}

std::optional<SimulatorClock> readClock(std::string_view message) {
  if (!message.starts_with("(clock ")) return std::nullopt;
  SExpressions expressions({.depth = 4, .nodes = 64});
  expressions.parse(message);
  const Node list = expressions.first();
  const auto paused = integerOf(list.list("paused").at(1));
  const auto speed = numberOf(list.list("speed").at(1));
  if (!paused || !speed || *speed < 0) return std::nullopt;
  return SimulatorClock{*paused != 0, *speed};
}

std::string TrainerCommandParser::parse(std::string_view text, std::vector<TrainerCommand>& commands) {
  std::string problem;
  wellFormed_ = expressions_.parse(text);
  if (!wellFormed_)
    problem = expressions_.error() + " at byte " + std::to_string(expressions_.errorPosition());
  for (auto node = expressions_.first(); node; node = node.next()) {
    wellFormed_ = wellFormed_ && node.isList();
    if (auto command = readOne(node)) {
      commands.push_back(std::move(*command));
    } else if (problem.empty()) {
      const std::string_view name = node.isList() ? node.name() : node.text();
      problem = "cannot use (" + std::string(name.substr(0, 20)) + " ...)";
    }
  }
  return problem;
}

}  // namespace plumbline::simspark
