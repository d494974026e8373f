#include <fmt/format.h>

#include "framework/YamlText.h"
#include "math/Angle.h"
#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/ExpectedFile.h"
#include "situation/Rounded.h"
#include "situation/SituationFile.h"

namespace plumbline {
namespace {

std::string pose(const Pose2& at) { return "[" + rounded(at.position) + ", " + rounded(at.heading) + "]"; }

std::string others(const Situation& situation, bool mates) {
  std::string rows;
  for (const OtherRobot& robot : situation.others)
    if (robot.mate == mates)
      rows += fmt::format("{}[{}{}]", rows.empty() ? "" : ", ", rounded(robot.position),
                          robot.number > 0 ? fmt::format(", {}", robot.number) : "");
  return "[" + rows + "]";
}

std::string velocities(const Situation& situation) {
  std::string rows;
  bool any = false;
  for (const OtherRobot& robot : situation.others) {
    if (!robot.mate) continue;
    any = any || rounded(robot.velocity) != "0, 0";
    rows += (rows.empty() ? "[" : ", [") + rounded(robot.velocity) + "]";
  }
  return any ? "velocities: [" + rows + "]\n" : "";
}

std::string strikersText(const Situation& situation) {
  std::string text = velocities(situation), rows;
  for (const PlacedPlayer& player : situation.going)
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", rounded(player.place.position),
                        rounded(player.heading));
  if (!rows.empty()) text += "going: [" + rows + "]\n";
  text += "kicks:  # m, m, degrees, m\n";
  for (const KickEffect& kick : situation.kicks)
    text += fmt::format("  - {{reach: {}, spread: {}, scatter: {}, rise: {}}}\n", rounded(kick.distance),
                        rounded(kick.spread), rounded(toDegrees(kick.scatter)), rounded(kick.rise));
  return text;
}

std::string teamsText(const Situation& situation) {
  std::string text =
      fmt::format("player: {}\nteam:  # number, x, y, heading, seconds to the ball\n", situation.player);
  for (const SaidPlace& said : situation.team)
    text += fmt::format("  - [{}, {}, {}, {}]\n", said.number, rounded(said.pose.position),
                        rounded(said.pose.heading), rounded(said.timeToBall));
  return text;
}

}  // namespace

std::string situationText(const Situation& s) {
  std::string text = fmt::format("about: {}\ndecides: {}\n", yamlText(s.about),
                                 deciderNames.at(static_cast<std::size_t>(s.decides)));
  const Decider decides = s.decides;
  if (knowsMode(decides)) text += fmt::format("mode: {}\n", teamPlayModeName(s.mode));
  if (decides == Decider::formation) text += teamsText(s);
  if (decides != Decider::formation && decides != Decider::block) {
    if (s.player > 0) text += fmt::format("player: {}\n", s.player);
    text += "robot: " + pose(s.robot) + "\n";
  }
  if (decides == Decider::supporter && s.place) text += "place: " + pose(*s.place) + "\n";
  text += "ball: [" + rounded(s.ball) + "]\n";
  if (decides == Decider::goalie) text += "velocity: [" + rounded(s.ballVelocity) + "]\n";
  if (decides == Decider::supporter && s.ballAge > 0) text += "ballAge: " + rounded(s.ballAge) + "\n";
  if (decides == Decider::block && s.opponentKick) text += "kickDistance: " + rounded(*s.opponentKick) + "\n";
  text += "mates: " + others(s, true) + "\nopponents: " + others(s, false) + "\n";
  if (decides == Decider::striker) text += strikersText(s);
  const std::string expected = expectedText(s.expected);
  return expected.empty() ? text : text + "expected: " + expected + "\n";
}

}  // namespace plumbline
