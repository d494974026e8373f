#include "simspark/FieldMessage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

namespace {

using Word = SExpressions::Node;
constexpr std::string_view beginning = "(field 1)";
constexpr std::size_t maxPlayMode = 30;
constexpr int maxCentimetres = 100000;  ///< what lies farther out is sent as this place
constexpr double uprightAxis = 0.5;     ///< upward part of the torso's axis of one that has not fallen

/// Sizes of the field, in the order of "(f ...)".
constexpr std::array<double FieldSize::*, 7> fieldSizes = {
    &FieldSize::length,       &FieldSize::width,        &FieldSize::goalWidth,         &FieldSize::goalDepth,
    &FieldSize::penaltyDepth, &FieldSize::penaltyWidth, &FieldSize::centreCircleRadius};

void appendCentimetres(std::string& out, double metres) {
  const double centimetres =
      std::clamp(std::round(metres * 100), -1.0 * maxCentimetres, 1.0 * maxCentimetres);
  out += ' ';
  appendInteger(out, std::isnan(centimetres) ? 0 : static_cast<int>(centimetres));
}

void appendWord(std::string& out, std::string_view name, const std::string& word, std::size_t longest) {
  if (word.empty()) return;
  out.append("(").append(name).append(" ").append(word, 0, longest).append(")");
}

/// Reads the numbers of a list from place `first` on; nothing else may stand there up to `count` of them.
bool readNumbers(Word list, int first, int count, double* numbers) {
  for (int i = 0; i < count; ++i) {
    const Word word = list.at(first + i);
    const auto value = word && !word.isList() ? parseNumber(word.text()) : std::nullopt;
    if (!value || std::abs(*value) > 1e6) return false;
    numbers[i] = *value;
  }
  return true;
}

bool readRobot(Word list, TeamSide side, FieldRobot& robot) {
  double numbers[4];
  if (!readNumbers(list, 1, 4, numbers) || numbers[0] < 0 || numbers[0] > 99) return false;
  robot.side = side;
  robot.unum = static_cast<int>(numbers[0]);
  robot.position = Vec2(numbers[1], numbers[2]) / 100;
  robot.heading = numbers[3] * std::numbers::pi / 180;
  const Word last = list.at(5);
  robot.fallen = last && !last.isList() && last.text() == "f";
  return true;
}

/// One list of a message; lists of other names are for later versions and skipped.
bool readPart(Word part, FieldState& state) {
  const std::string_view name = part.name();
  const Word value = part.at(1);
  double numbers[3];
  if (name == "t") {
    if (!readNumbers(part, 1, 1, numbers)) return false;
    state.time = numbers[0];
  } else if (name == "s") {
    if (!readNumbers(part, 1, 3, numbers)) return false;
    state.half = static_cast<int>(numbers[0]);
    state.scoreLeft = static_cast<int>(numbers[1]);
    state.scoreRight = static_cast<int>(numbers[2]);
  } else if (name == "b") {
    if (!readNumbers(part, 1, 3, numbers)) return false;
    state.ball = Vec3(numbers[0], numbers[1], numbers[2]) / 100;
  } else if (name == "m" || name == "nl" || name == "nr") {
    if (!value || value.isList()) return false;
    (name == "m" ? state.playMode : name == "nl" ? state.teamLeft : state.teamRight) = value.text();
  } else if (name == "f") {
    double sizes[fieldSizes.size()];
    if (!readNumbers(part, 1, static_cast<int>(fieldSizes.size()), sizes)) return false;
    for (std::size_t i = 0; i < fieldSizes.size(); ++i) {
      if (sizes[i] < 1) return false;
      state.field.*fieldSizes[i] = sizes[i] / 100;
    }
  } else if (name == "l" || name == "r" || name == "o") {
    const TeamSide side = name == "l" ? TeamSide::left : name == "r" ? TeamSide::right : TeamSide::none;
    return state.robots.size() < maxFieldRobots && readRobot(part, side, state.robots.emplace_back());
  }
  return true;
}

}  // namespace

FieldState fieldState(const SceneState& scene) {
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0; };
  const Scoreboard& board = scene;
  FieldState state{board, {}, {}};
  state.ball = scene.ball.unaryExpr(finite);
  for (const SceneRobot& robot : scene.robots)
    state.robots.push_back({robot.side, robot.unum,
                            robot.T_world_torso.translation().head<2>().unaryExpr(finite),
                            finite(robot.heading()), robot.T_world_torso.linear()(2, 2) < uprightAxis});
  return state;
}

std::string writeFieldMessage(const FieldState& state) {
  std::string out(beginning);
  out += "(t ";
  appendFixed(out, std::isfinite(state.time) ? std::clamp(state.time, -99999.0, 99999.0) : 0, 2);
  out += ")(s";
  for (const int number : {state.half, state.scoreLeft, state.scoreRight}) {
    out += ' ';
    appendInteger(out, std::clamp(number, -999, 999));
  }
  out += ')';
  appendWord(out, "m", state.playMode, maxPlayMode);
  appendWord(out, "nl", state.teamLeft, maxFieldTeamName);
  appendWord(out, "nr", state.teamRight, maxFieldTeamName);
  if (state.field != FieldSize()) {
    out += "(f";
    for (const auto size : fieldSizes) appendCentimetres(out, state.field.*size);
    out += ')';
  }
  out += "(b";
  for (int axis = 0; axis < 3; ++axis) appendCentimetres(out, state.ball[axis]);
  out += ')';
  for (std::size_t i = 0; i < std::min(state.robots.size(), maxFieldRobots); ++i) {
    const FieldRobot& robot = state.robots[i];
    out += robot.side == TeamSide::left ? "(l " : robot.side == TeamSide::right ? "(r " : "(o ";
    appendInteger(out, std::clamp(robot.unum, 0, 99));
    appendCentimetres(out, robot.position.x());
    appendCentimetres(out, robot.position.y());
    out += ' ';
    const double degrees = std::remainder(robot.heading * 180 / std::numbers::pi, 360);
    appendInteger(out, std::isfinite(degrees) ? static_cast<int>(std::lround(degrees)) : 0);
    out += robot.fallen ? " f)" : ")";
  }
  return out;
}

bool isFieldMessage(std::string_view message) { return message.starts_with("(field "); }

std::string readFieldMessage(std::string_view message, FieldState& state) {
  SExpressions expressions({.depth = 2, .nodes = 1024});
  if (!expressions.parse(message))
    return expressions.error() + " at byte " + std::to_string(expressions.errorPosition());
  const Word first = expressions.first();
  if (!first || first.name() != "field") return "no field message";
  const Word version = first.at(1);
  if (!version || version.text() != "1")
    return "field protocol " + std::string(version ? version.text().substr(0, 20) : "?") +
           ", this program knows version 1";
  FieldState read;
  for (Word part = first.next(); part; part = part.next())
    if (!part.isList() || !readPart(part, read))
      return "cannot use (" +
             std::string(part.isList() ? part.name().substr(0, 20) : part.text().substr(0, 20)) + " ...)";
  state = std::move(read);
  return {};
}

}  // namespace plumbline::simspark
