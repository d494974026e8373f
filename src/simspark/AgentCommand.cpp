#include "simspark/AgentCommand.h"

#include <algorithm>

#include "simspark/JointNames.h"
#include "simspark/NumberFormat.h"
#include "simspark/WordNumbers.h"

namespace plumbline::simspark {

namespace {
constexpr int commandDecimals = 5;
constexpr std::size_t maxSay = 20, maxTeamName = 20;

/// Numbers of the children 1..n of a list; false if one is missing or no number.
template <std::size_t n>
bool numbers(SExpressions::Node list, std::array<double, n>& values) {
  SExpressions::Node child = list.first();
  for (double& value : values) {
    child = child ? child.next() : child;
    if (!child || child.isList()) return false;
    const auto number = parseNumber(child.text());
    if (!number) return false;
    value = *number;
  }
  return true;
}

bool readOne(SExpressions::Node list, AgentCommand& command) {
  const std::string_view name = list.name();
  if (const JointId joint = jointByEffector(name); joint != noJoint) {
    std::array<double, 1> speed;
    if (!numbers(list, speed)) return false;
    command.velocity[joint] = simsparkName(joint).sign * speed[0];
    return true;
  }
  if (name == "syn") return command.syn = true;
  if (name == "pass") return command.pass = true;
  if (name == "beam") {
    std::array<double, 3> pose;
    if (!numbers(list, pose)) return false;
    command.beam = Pose2(pose[0], pose[1], fromDegrees(pose[2]));
    return true;
  }
  if (name == "say") {
    const auto text = list.at(1);
    if (!text || text.isList() || text.next() || !isSayable(text.text())) return false;
    command.say = text.text();
    return true;
  }
  if (name == "scene") {
    const auto file = list.at(1);
    if (!file || file.isList()) return false;
    const auto type = file.next() ? integerOf(file.next()) : 0;
    if (!type) return false;
    command.scene = SceneRequest{std::string(file.text()), *type};
    return true;
  }
  if (name == "init") {
    const auto team = list.list("teamname").at(1);
    const auto unum = integerOf(list.list("unum").at(1));
    if (!team || team.isList() || !unum) return false;
    command.init = InitRequest{*unum, std::string(team.text())};
    return true;
  }
  return false;
}
}  // namespace

bool isSayable(std::string_view text) {
  return !text.empty() && text.size() <= maxSay && std::all_of(text.begin(), text.end(), [](char c) {
    return c > ' ' && c <= '~' && c != '(' && c != ')';
  });
}

bool isTeamName(std::string_view text) {
  return !text.empty() && text.size() <= maxTeamName && std::all_of(text.begin(), text.end(), [](char c) {
    return c > ' ' && c <= '~' && c != '(' && c != ')' && c != '"';
  });
}

void appendAgentCommand(std::string& out, const AgentCommand& command) {
  if (command.scene) {
    out += "(scene " + command.scene->file + ' ';
    appendInteger(out, command.scene->type);
    out += ')';
  }
  if (command.init) {
    out += "(init (unum ";
    appendInteger(out, command.init->unum);
    out += ")(teamname " + command.init->team + "))";
  }
  if (command.beam) {
    out += "(beam";
    for (const double value : {command.beam->x(), command.beam->y(), toDegrees(command.beam->heading)}) {
      out += ' ';
      appendFixed(out, value, commandDecimals);
    }
    out += ')';
  }
  for (int i = 0; i < numHumanoidJoints; ++i) {
    if (!command.velocity[i]) continue;
    const JointName& name = simsparkName(static_cast<JointId>(i));
    out += '(';
    out += name.effector;
    out += ' ';
    appendFixed(out, name.sign * *command.velocity[i], commandDecimals);
    out += ')';
  }
  if (command.say) out += "(say " + *command.say + ')';
  if (command.pass) out += "(pass)";
  if (command.syn) out += "(syn)";
}

std::string writeAgentCommand(const AgentCommand& command) {
  std::string out;
  appendAgentCommand(out, command);
  return out;
}

std::string AgentCommandParser::parse(std::string_view text, AgentCommand& command) {
  command = AgentCommand();
  std::string problem;
  wellFormed_ = expressions_.parse(text);
  if (!wellFormed_)
    problem = expressions_.error() + " at byte " + std::to_string(expressions_.errorPosition());
  for (auto node = expressions_.first(); node; node = node.next()) {
    wellFormed_ = wellFormed_ && node.isList();
    if (readOne(node, command) || !problem.empty()) continue;
    const std::string_view name = node.isList() ? node.name() : node.text();
    problem = "cannot use (" + std::string(name.substr(0, 20)) + " ...)";
  }
  return problem;
}

}  // namespace plumbline::simspark
