#include "situation/kinds/StrikerSituationKind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/Angle.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/skills/SkillKickParameters.h"
#include "situation/CycleOfLog.h"
#include "situation/Rounded.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

constexpr double longestSector = 5;  // [m]
constexpr std::size_t mostKicks = 20;

/// Of each mate in their order: its velocity, and the place that it goes to with the heading it has now.
void readMotion(const ConfigSection& root, Situation& situation) {
  std::size_t mates = 0;
  while (mates < situation.others.size() && situation.others[mates].mate) ++mates;
  const auto perMate = [&](const char* key, std::size_t values, const char* form) {
    auto rows = readRows(root, key, values, values, form);
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

std::shared_ptr<const StrikerKnowledge> readKicks(const ConfigSection& root) {
  constexpr double farthest = SituationLimits::farthest;
  const auto kicks = root.list("kicks");
  if (kicks.size() > mostKicks)
    root.fail("kicks", fmt::format("must have {} at most, not {}", mostKicks, kicks.size()));
  auto known = std::make_shared<StrikerKnowledge>();
  for (const ConfigSection& kick : kicks)
    known->kicks.push_back({.distance = kick.get<double>("reach", 0.01, farthest),
                            .scatter = fromDegrees(kick.get<double>("scatter", 0, 180)),
                            .spread = kick.get<double>("spread", 0, farthest),
                            .rise = kick.get<double>("rise", 0, farthest)});
  return known;
}

std::string velocitiesText(const Situation& situation) {
  std::string rows;
  bool any = false;
  for (const OtherRobot& robot : situation.others) {
    if (!robot.mate) continue;
    any = any || rounded(robot.velocity) != "0, 0";
    rows += (rows.empty() ? "[" : ", [") + rounded(robot.velocity) + "]";
  }
  return any ? "velocities: [" + rows + "]\n" : "";
}

/// Mates whose places are known come first: the rows of `going` belong to the mates in their order.
void takeMates(const CycleOfLog& cycle, Situation& situation) {
  const TeamPlaces places = cycle.get<TeamPlaces>();
  const auto placeOf = [&](const OtherRobot& robot) -> const PlacedPlayer* {
    const PlacedPlayer* place = robot.mate && robot.number > 0 ? places.of(robot.number) : nullptr;
    return place && place->placed ? place : nullptr;
  };
  std::stable_partition(situation.others.begin(), situation.others.end(),  // clang 14 has no ranges' one
                        [&](const OtherRobot& robot) { return placeOf(robot) != nullptr; });
  for (const OtherRobot& robot : situation.others)
    if (const PlacedPlayer* place = placeOf(robot)) situation.going.push_back(*place);
}

std::string degreesWords(double angle) {
  const double degrees = std::round(toDegrees(angle));
  return degrees == 0 ? "straight ahead"
                      : fmt::format("{:g} degrees {}", std::abs(degrees), degrees > 0 ? "left" : "right");
}

/// The middle of what is expected; what goes out of the field ends behind the line.
Vec2 endOf(const StrikerExpected& expected, const Situation& s, const FieldSize& field) {
  double radius = 0;
  for (const KickEffect& kick : knownTo<StrikerKnowledge>(s).kicks) radius = std::max(radius, kick.distance);
  if (expected.reach) radius = std::min(radius, (*expected.reach)[1]);
  radius = std::clamp(radius, 1.0, longestSector);
  const double middle = (expected.direction[0] + expected.direction[1]) / 2;
  const Vec2 direction(std::cos(middle), std::sin(middle));
  const Vec2 lines(field.length / 2, field.width / 2);
  for (const int axis : {0, 1}) {
    const double line = std::copysign(lines[axis] + field.goalDepth, direction[axis]);
    if (std::abs(direction[axis]) > 1e-9)
      radius = std::min(radius, std::max(1.0, (line - s.ball[axis]) / direction[axis]));
  }
  return s.ball + radius * direction;
}

class StrikerSituationKind : public SituationKind {
public:
  StrikerSituationKind()
      : SituationKind(
            {.name = "striker", .order = 10, .heading = "The striker: what it does with the ball"}) {}

  void read(const ConfigSection& root, Situation& situation) const override {
    readMotion(root, situation);
    situation.known = readKicks(root);
  }

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    auto expected = std::make_shared<StrikerExpected>();
    expected->action = readChoice<StrikerExpected::Action>(section, "action", StrikerExpected::actionNames);
    const Vec2 direction = section.get<Vec2>("direction", Range(-2 * pi, 2 * pi));
    if (direction[0] > direction[1])
      section.fail("direction", fmt::format("must be [from, to] with the smaller one first, not [{:g}, {:g}]",
                                            direction[0], direction[1]));
    expected->direction = direction;
    expected->reach = section.find<Vec2>("reach", SituationLimits::distances());
    return expected;
  }

  KindText text(const Situation& situation) const override {
    std::string text = velocitiesText(situation), rows;
    for (const PlacedPlayer& player : situation.going)
      rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", rounded(player.place.position),
                          rounded(player.heading));
    if (!rows.empty()) text += "going: [" + rows + "]\n";
    text += "kicks:  # m, m, degrees, m\n";
    for (const KickEffect& kick : knownTo<StrikerKnowledge>(situation).kicks)
      text += fmt::format("  - {{reach: {}, spread: {}, scatter: {}, rise: {}}}\n", rounded(kick.distance),
                          rounded(kick.spread), rounded(toDegrees(kick.scatter)), rounded(kick.rise));
    return {.afterOthers = text};
  }

  void take(const CycleOfLog& cycle, Situation& situation) const override {
    takeMates(cycle, situation);
    auto known = std::make_shared<StrikerKnowledge>();
    for (const Kick& kick : cycle.get<SkillKickParameters>().kicks) known->kicks.push_back(kick);
    situation.known = known;
  }
};

MAKE_SITUATION_KIND(StrikerSituationKind)

}  // namespace

std::string StrikerExpected::text() const {
  return fmt::format("{{action: {}, {}direction: [{}]}}", actionNames.at(static_cast<std::size_t>(action)),
                     reach ? "reach: [" + rounded(*reach) + "], " : "", rounded(direction));
}

std::string StrikerExpected::words(int /*player*/) const {
  const char* actions[] = {"kicks or dribbles", "kicks", "dribbles"};
  return fmt::format(
      "{} between {} and {}{}", actions[static_cast<int>(action)], degreesWords(direction[0]),
      degreesWords(direction[1]),
      reach ? fmt::format(", {} to {} m far", rounded((*reach)[0]), rounded((*reach)[1])) : "");
}

std::vector<Vec2> StrikerExpected::places(const Situation& situation, const FieldSize& field) const {
  return {endOf(*this, situation, field)};
}

void StrikerExpected::draw(const Situation& situation, const FieldSize& field,
                           SituationCanvas& canvas) const {
  const Vec2 end = endOf(*this, situation, field);
  const char* actions[] = {"kick or dribble", "kick", "dribble"};
  canvas.sector(situation.ball, (end - situation.ball).norm(), direction[0], direction[1]);
  canvas.arrow(situation.ball, end);
  canvas.label(end, actions[static_cast<int>(action)]);
}

}  // namespace plumbline
