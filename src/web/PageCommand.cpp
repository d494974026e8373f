#include "web/PageCommand.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "field/TeamSize.h"

namespace plumbline::web {

using nlohmann::json;
using namespace simspark;

namespace {

constexpr double reach = 100;  ///< nothing is put further from the field's middle [m]

double number(const json& message, const char* key, double lower, double upper) {
  const auto found = message.find(key);
  if (found == message.end() || !found->is_number())
    throw std::invalid_argument(std::string("no number '") + key + '\'');
  const double value = found->get<double>();
  if (!(value >= lower && value <= upper))
    throw std::invalid_argument(std::string("'") + key + "' is out of range");
  return value;
}

TeamSide side(const json& message) {
  const std::string name = message.value("side", "");
  if (name == "left") return TeamSide::left;
  if (name == "right") return TeamSide::right;
  throw std::invalid_argument("'side' is neither left nor right");
}

Vec3 position(const json& message) {
  return {number(message, "x", -reach, reach), number(message, "y", -reach, reach),
          number(message, "z", 0, reach)};
}

TrainerCommand moveRobot(const json& message) {
  MoveAgentCommand command;
  command.player = PlayerName{static_cast<int>(number(message, "unum", 1, teamSize)), side(message)};
  command.position = position(message);
  if (message.contains("heading")) command.heading = number(message, "heading", -10, 10);
  return command;
}

TrainerCommand playMode(const json& message) {
  const auto mode = playModeByName(message.value("mode", ""));
  if (!mode) throw std::invalid_argument("'mode' is no play mode");
  return PlayModeCommand{*mode};
}

PageCommand read(const json& message) {
  using Kind = ClockCommand::Kind;
  using Reader = PageCommand (*)(const json&);
  static const std::map<std::string, Reader, std::less<>> readers = {
      {"kickOff", [](const json& m) -> PageCommand { return TrainerCommand(KickOffCommand{side(m)}); }},
      {"playMode", [](const json& m) -> PageCommand { return playMode(m); }},
      {"dropBall", [](const json&) -> PageCommand { return TrainerCommand(DropBallCommand{}); }},
      {"moveRobot", [](const json& m) -> PageCommand { return moveRobot(m); }},
      {"moveBall",
       [](const json& m) -> PageCommand {
         return TrainerCommand(BallCommand{position(m), Vec3::Zero()});
       }},
      {"kickBall",
       [](const json& m) -> PageCommand {
         return TrainerCommand(BallCommand{
             {}, Vec3(number(m, "x", -30, 30), number(m, "y", -30, 30), number(m, "z", -30, 30))});
       }},
      {"reset", [](const json&) -> PageCommand { return ResetGame{}; }},
      {"pause", [](const json&) -> PageCommand { return TrainerCommand(ClockCommand{Kind::pause}); }},
      {"resume", [](const json&) -> PageCommand { return TrainerCommand(ClockCommand{Kind::resume}); }},
      {"step",
       [](const json& m) -> PageCommand {
         return TrainerCommand(ClockCommand{Kind::step, number(m, "cycles", 1, 1000)});
       }},
      {"speed",
       [](const json& m) -> PageCommand {
         const double speed = number(m, "speed", 0, maxSpeed);
         if (speed != 0 && speed < minSpeed) throw std::invalid_argument("'speed' is out of range");
         return TrainerCommand(ClockCommand{Kind::speed, speed});
       }},
      {"seek", [](const json& m) -> PageCommand { return Seek{number(m, "time", 0, 1e9)}; }},
      {"play", [](const json&) -> PageCommand { return PlayRecording{true}; }},
      {"stop", [](const json&) -> PageCommand { return PlayRecording{false}; }},
      {"rate", [](const json& m) -> PageCommand { return RecordingRate{number(m, "rate", 0.05, 100)}; }},
  };
  const auto reader = readers.find(message.value("do", ""));
  if (reader == readers.end()) throw std::invalid_argument("no such command");
  return reader->second(message);
}

}  // namespace

std::string parsePageCommand(std::string_view text, PageCommand& command) {
  const json message = json::parse(text, nullptr, false);
  if (!message.is_object()) return "not a JSON object";
  try {
    command = read(message);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const json::exception&) {
    return "a value of the wrong type";
  }
}

std::vector<TrainerCommand> resetGame(const FieldSize& field) {
  return {PlayModeCommand{PlayMode::beforeKickOff}, ScoreCommand{0, 0}, TimeCommand{0},
          BallCommand{Vec3(0, 0, field.ballRadius), Vec3::Zero()}};
}

}  // namespace plumbline::web
