#include "situation/ExpectedFile.h"

#include <fmt/format.h>

#include "field/TeamSize.h"
#include "framework/ConfigSection.h"
#include "math/Angle.h"
#include "representations/behavior/Skill.h"
#include "situation/Rounded.h"

namespace plumbline {
namespace {

const Range onField(-SituationLimits::farthest, SituationLimits::farthest),
    distances(0, SituationLimits::farthest), numbers(0, teamSize);

template <typename Choice, std::size_t n>
Choice chosen(const ConfigSection& section, const char* key, const std::array<const char*, n>& names) {
  return static_cast<Choice>(section.choice(key, {names.begin(), names.end()}));
}

StrikerExpected readStriker(const ConfigSection& section) {
  StrikerExpected expected;
  expected.action = chosen<StrikerExpected::Action>(section, "action", StrikerExpected::actionNames);
  expected.direction = section.get<Vec2>("direction", Range(-2 * pi, 2 * pi));
  if (expected.direction[0] > expected.direction[1])
    section.fail("direction", fmt::format("must be [from, to] with the smaller one first, not [{:g}, {:g}]",
                                          expected.direction[0], expected.direction[1]));
  expected.reach = section.find<Vec2>("reach", distances);
  return expected;
}

FormationExpected readFormation(const ConfigSection& section) {
  FormationExpected expected;
  expected.striker = section.get<int>("striker", numbers);
  expected.role = chosen<FormationExpected::Role>(section, "role", FormationExpected::roleNames);
  expected.area = section.find<std::array<double, 4>>("area", onField);
  if (const auto& area = expected.area; area && ((*area)[0] > (*area)[1] || (*area)[2] > (*area)[3]))
    section.fail("area", "must be [x from, x to, y from, y to] with the smaller one of each first");
  return expected;
}

/// A supporter's target has a heading, that of a set piece has none.
SkillExpected readSkill(const ConfigSection& section, bool hasHeading) {
  SkillExpected expected;
  expected.skill = Skill::names[section.choice("skill", {Skill::names.begin(), Skill::names.end()})];
  if (!hasHeading || section.has("target")) {
    if (hasHeading) {
      const Vec3 target = section.get<Vec3>("target", onField);
      expected.target = target.head<2>();
      expected.heading = target.z();
    } else {
      expected.target = section.get<Vec2>("target", onField);
    }
    expected.within = section.get<double>("within", distances);
  }
  return expected;
}

BlockExpected readBlock(const ConfigSection& section) {
  BlockExpected expected;
  expected.opponent = section.get<int>("opponent", numbers);
  if (expected.opponent == 0) return expected;
  expected.place = section.get<Vec2>("place", onField);
  expected.within = section.get<double>("within", distances);
  return expected;
}

std::string degreesWords(double angle) {
  const double degrees = std::round(toDegrees(angle));
  return degrees == 0 ? "straight ahead"
                      : fmt::format("{:g} degrees {}", std::abs(degrees), degrees > 0 ? "left" : "right");
}

std::string placeWords(const Vec2& place) { return "(" + rounded(place) + ")"; }

std::string skillWords(const std::string& skill) {
  return skill == Skill::moveToPos ? "goes" : skill == Skill::stand ? "stands" : skill + "s";
}

struct Text {
  std::string operator()(const std::monostate&) const { return ""; }
  std::string operator()(const StrikerExpected& e) const {
    return fmt::format("{{action: {}, {}direction: [{}]}}",
                       StrikerExpected::actionNames.at(static_cast<std::size_t>(e.action)),
                       e.reach ? "reach: [" + rounded(*e.reach) + "], " : "", rounded(e.direction));
  }
  std::string operator()(const GoalieExpected& e) const {
    return fmt::format("{{place: [{}], within: {}{}}}", rounded(e.place), rounded(e.within),
                       e.fromTheWay ? ", fromTheWay: " + rounded(*e.fromTheWay) : "");
  }
  std::string operator()(const FormationExpected& e) const {
    return fmt::format("{{striker: {}, role: {}{}}}", e.striker,
                       FormationExpected::roleNames.at(static_cast<std::size_t>(e.role)),
                       e.area ? ", area: [" + rounded(*e.area) + "]" : "");
  }
  std::string operator()(const SkillExpected& e) const {
    std::string target;
    if (e.target)
      target = fmt::format(", target: [{}{}], within: {}", rounded(*e.target),
                           e.heading ? ", " + rounded(*e.heading) : "", rounded(e.within));
    return fmt::format("{{skill: {}{}}}", e.skill, target);
  }
  std::string operator()(const BlockExpected& e) const {
    if (e.opponent == 0) return "{opponent: 0}";
    return fmt::format("{{opponent: {}, place: [{}], within: {}}}", e.opponent, rounded(e.place),
                       rounded(e.within));
  }
  std::string operator()(const CallExpected& e) const { return fmt::format("{{asks: {}}}", e.asks); }
};

struct Words {
  int player;
  std::string operator()(const std::monostate&) const { return ""; }
  std::string operator()(const StrikerExpected& e) const {
    const char* actions[] = {"kicks or dribbles", "kicks", "dribbles"};
    return fmt::format(
        "{} between {} and {}{}", actions[static_cast<int>(e.action)], degreesWords(e.direction[0]),
        degreesWords(e.direction[1]),
        e.reach ? fmt::format(", {} to {} m far", rounded((*e.reach)[0]), rounded((*e.reach)[1])) : "");
  }
  std::string operator()(const GoalieExpected& e) const {
    return fmt::format(
        "goes to {} within {} m{}", placeWords(e.place), rounded(e.within),
        e.fromTheWay ? fmt::format(", at most {} m from the ball's way", rounded(*e.fromTheWay)) : "");
  }
  std::string operator()(const FormationExpected& e) const {
    std::string words = fmt::format("number {} goes to the ball", e.striker);
    if (e.role == FormationExpected::Role::striker) return words;
    words += fmt::format("; number {} is {}", player,
                         e.role == FormationExpected::Role::goalie ? "the goalie" : "a supporter");
    if (e.area) {
      const auto& a = *e.area;
      words += fmt::format(" at x {} to {}, y {} to {}", rounded(a[0]), rounded(a[1]), rounded(a[2]),
                           rounded(a[3]));
    }
    return words;
  }
  std::string operator()(const SkillExpected& e) const {
    std::string words = skillWords(e.skill);
    if (e.target) words += fmt::format(" to {} within {} m", placeWords(*e.target), rounded(e.within));
    if (e.heading) words += fmt::format(", turned {:.0f} degrees", toDegrees(*e.heading));
    return words;
  }
  std::string operator()(const BlockExpected& e) const {
    if (e.opponent == 0) return "nobody is blocked";
    return fmt::format("number {} is blocked from {} within {} m", e.opponent, placeWords(e.place),
                       rounded(e.within));
  }
  std::string operator()(const CallExpected& e) const {
    return e.asks ? "asks for pass mode" : "does not ask for pass mode";
  }
};

}  // namespace

Expected readExpected(const ConfigSection& section, Decider decider) {
  switch (decider) {
    case Decider::striker:
      return readStriker(section);
    case Decider::goalie:
      return GoalieExpected{section.get<Vec2>("place", onField), section.get<double>("within", distances),
                            section.find<double>("fromTheWay", distances)};
    case Decider::formation:
      return readFormation(section);
    case Decider::supporter:
    case Decider::setPiece:
      return readSkill(section, decider == Decider::supporter);
    case Decider::block:
      return readBlock(section);
    case Decider::passCall:
      return CallExpected{section.get<bool>("asks")};
  }
  return {};
}

std::string expectedText(const Expected& expected) { return std::visit(Text(), expected); }

std::string expectedWords(const Expected& expected, int player) {
  return std::visit(Words{player}, expected);
}

}  // namespace plumbline
