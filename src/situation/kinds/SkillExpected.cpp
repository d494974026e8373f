#include "situation/kinds/SkillExpected.h"

#include <fmt/format.h>

#include <cmath>

#include "math/Angle.h"
#include "representations/behavior/Skill.h"
#include "situation/Rounded.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

std::string skillWords(const std::string& skill) {
  return skill == Skill::moveToPos ? "goes" : skill == Skill::stand ? "stands" : skill + "s";
}

}  // namespace

std::shared_ptr<const SkillExpected> SkillExpected::read(const ConfigSection& section, bool hasHeading) {
  auto expected = std::make_shared<SkillExpected>();
  expected->skill = Skill::names[section.choice("skill", {Skill::names.begin(), Skill::names.end()})];
  if (hasHeading && !section.has("target")) return expected;
  if (hasHeading) {
    const Vec3 target = section.get<Vec3>("target", SituationLimits::places());
    expected->target = target.head<2>();
    expected->heading = target.z();
  } else {
    expected->target = section.get<Vec2>("target", SituationLimits::places());
  }
  expected->within = section.get<double>("within", SituationLimits::distances());
  return expected;
}

std::string SkillExpected::text() const {
  std::string rest;
  if (target)
    rest = fmt::format(", target: [{}{}], within: {}", rounded(*target),
                       heading ? ", " + rounded(*heading) : "", rounded(within));
  return fmt::format("{{skill: {}{}}}", skill, rest);
}

std::string SkillExpected::words(int /*player*/) const {
  std::string words = skillWords(skill);
  if (target) words += fmt::format(" to {} within {} m", placeWords(*target), rounded(within));
  if (heading) words += fmt::format(", turned {:.0f} degrees", toDegrees(*heading));
  return words;
}

std::vector<Vec2> SkillExpected::places(const Situation&, const FieldSize&) const {
  if (!target) return {};
  return {*target};
}

void SkillExpected::draw(const Situation& situation, const FieldSize&, SituationCanvas& canvas) const {
  if (!target) return canvas.label(situation.robot.position, skill);
  if (skill == Skill::kick || skill == Skill::dribble) {
    canvas.ring(*target, within);
    canvas.arrow(situation.ball, *target);
    return canvas.label(*target, skill);
  }
  canvas.way(situation.robot.position, *target, within, skill);
  if (heading) canvas.arrow(*target, *target + 0.8 * Vec2(std::cos(*heading), std::sin(*heading)));
}

}  // namespace plumbline
