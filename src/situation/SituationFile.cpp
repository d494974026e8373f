#include "situation/SituationFile.h"

#include <fmt/format.h>

#include <cmath>

#include "field/TeamSize.h"
#include "framework/ConfigFile.h"
#include "math/Angle.h"
#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/ExpectedFile.h"

namespace plumbline {
namespace {

constexpr double farthest = SituationLimits::farthest;
constexpr double fastest = 30;    // [m/s]
constexpr double longest = 1000;  // [s]
constexpr std::size_t mostKicks = 20, mostWords = 400;
const Range places(-farthest, farthest), times(0, longest);

template <std::size_t n>
std::vector<std::string> wordsOf(const std::array<const char*, n>& names) {
  return {names.begin(), names.end()};
}

Pose2 poseOf(const ConfigSection& root, const char* key) {
  const Vec3 pose = root.get<Vec3>(key, places);
  return {pose.x(), pose.y(), pose.z()};
}

int numberOf(const ConfigSection& root, const char* key, double number) {
  if (number != std::floor(number) || number < 0 || number > teamSize)
    root.fail(key, fmt::format("has {:g} where a player's number from 0 (not known) to {} must be", number,
                               teamSize));
  return static_cast<int>(number);
}

/// Rows of numbers: at most so many, each of a length within the bounds; none if the key is missing.
std::vector<std::vector<double>> rowsOf(const ConfigSection& root, const char* key, std::size_t least,
                                        std::size_t most, const char* form) {
  auto rows =
      root.find<std::vector<std::vector<double>>>(key, places).value_or(std::vector<std::vector<double>>());
  if (rows.size() > teamSize)
    root.fail(key, fmt::format("must have {} at most, not {}", teamSize, rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].size() < least || rows[i].size() > most)
      root.fail(key, fmt::format("must be a list of {}; number {} of it has {} values", form, i + 1,
                                 rows[i].size()));
  return rows;
}

void readOthers(const ConfigSection& root, Situation& situation) {
  for (const bool mate : {true, false}) {
    const char* key = mate ? "mates" : "opponents";
    for (const auto& row : rowsOf(root, key, 2, 3, "[x, y] or [x, y, number]")) {
      OtherRobot& robot = situation.others.emplace_back();
      robot.mate = mate;
      robot.position = {row[0], row[1]};
      robot.number = row.size() > 2 ? numberOf(root, key, row[2]) : 0;
    }
  }
}

/// Of each mate in their order: its velocity, and the place that it goes to with the heading it has now.
void readMotion(const ConfigSection& root, Situation& situation) {
  std::size_t mates = 0;
  while (mates < situation.others.size() && situation.others[mates].mate) ++mates;
  const auto perMate = [&](const char* key, std::size_t values, const char* form) {
    auto rows = rowsOf(root, key, values, values, form);
    if (rows.size() > mates)
      root.fail(key, fmt::format("must have one for each mate, {} at most, not {}", mates, rows.size()));
    return rows;
  };
  const auto velocities = perMate("velocities", 2, "[x, y]");
  for (std::size_t i = 0; i < velocities.size(); ++i)
    situation.others[i].velocity = {velocities[i][0], velocities[i][1]};
  const auto going = perMate("going", 3, "[x, y, heading]");
  for (std::size_t i = 0; i < going.size(); ++i) {
    PlacedPlayer& player = situation.going.emplace_back();
    player.number = situation.others[i].number;
    player.heading = going[i][2];
    player.placed = true;
    player.place = Pose2(going[i][0], going[i][1], 0);
  }
}

void readTeam(const ConfigSection& root, Situation& situation) {
  situation.player = root.get<int>("player", 1, teamSize);
  bool found = false;
  for (const auto& row : rowsOf(root, "team", 5, 5, "[number, x, y, heading, seconds to the ball]")) {
    const SaidPlace said{numberOf(root, "team", row[0]), Pose2(row[1], row[2], row[3]), row[4]};
    if (said.timeToBall < 0) root.fail("team", fmt::format("must not have {:g} s to the ball", row[4]));
    situation.team.push_back(said);
    if (said.number != situation.player) continue;
    situation.robot = said.pose;
    found = true;
  }
  if (!found)
    root.fail("player",
              fmt::format("must be one of the team's, not {}: its place is there", situation.player));
}

void readKicks(const ConfigSection& root, Situation& situation) {
  const auto kicks = root.list("kicks");
  if (kicks.size() > mostKicks)
    root.fail("kicks", fmt::format("must have {} at most, not {}", mostKicks, kicks.size()));
  for (const ConfigSection& kick : kicks)
    situation.kicks.push_back({.distance = kick.get<double>("reach", 0.01, farthest),
                               .scatter = fromDegrees(kick.get<double>("scatter", 0, 180)),
                               .spread = kick.get<double>("spread", 0, farthest),
                               .rise = kick.get<double>("rise", 0, farthest)});
}

void readOwn(const ConfigSection& root, Situation& situation) {
  switch (situation.decides) {
    case Decider::striker:
      situation.robot = poseOf(root, "robot");
      readMotion(root, situation);
      readKicks(root, situation);
      return;
    case Decider::goalie:
      situation.robot = poseOf(root, "robot");
      situation.ballVelocity = root.get<Vec2>("velocity", Range(-fastest, fastest));
      return;
    case Decider::formation:
      return readTeam(root, situation);
    case Decider::supporter:
      situation.robot = poseOf(root, "robot");
      situation.place = poseOf(root, "place");
      situation.ballAge = root.find<double>("ballAge", times).value_or(0);
      return;
    case Decider::block:
      situation.opponentKick = root.find<double>("kickDistance", Range(0, farthest));
      return;
    case Decider::setPiece:
    case Decider::passCall:
      situation.robot = poseOf(root, "robot");
      return;
  }
}

}  // namespace

Situation readSituation(const std::string& path) {
  const ConfigFile file(path);
  const ConfigSection& root = file.root();
  Situation situation;
  situation.about = root.get<std::string>("about");
  if (situation.about.size() > mostWords)
    root.fail("about",
              fmt::format("must have {} characters at most, not {}", mostWords, situation.about.size()));
  situation.decides = static_cast<Decider>(root.choice("decides", wordsOf(deciderNames)));
  if (knowsMode(situation.decides) && root.has("mode"))
    situation.mode = static_cast<TeamPlayMode>(root.choice("mode", wordsOf(teamPlayModeNames)));
  if (situation.decides != Decider::formation && situation.decides != Decider::block)
    situation.player = root.find<int>("player", Range(0, teamSize)).value_or(0);
  situation.ball = root.get<Vec2>("ball", places);
  readOthers(root, situation);
  readOwn(root, situation);
  if (root.has("expected")) situation.expected = readExpected(root.section("expected"), situation.decides);
  file.checkUnknown();
  return situation;
}

}  // namespace plumbline
