#include <fmt/format.h>

#include "framework/YamlText.h"
#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/Rounded.h"
#include "situation/SituationFile.h"
#include "situation/SituationKind.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

std::string othersText(const Situation& situation, bool mates) {
  std::string rows;
  for (const OtherRobot& robot : situation.others)
    if (robot.mate == mates)
      rows += fmt::format("{}[{}{}]", rows.empty() ? "" : ", ", rounded(robot.position),
                          robot.number > 0 ? fmt::format(", {}", robot.number) : "");
  return "[" + rows + "]";
}

}  // namespace

std::string situationText(const Situation& s) {
  const SituationTraits& kind = s.kind->traits;
  const KindText own = s.kind->text(s);
  std::string text = fmt::format("about: {}\ndecides: {}\n", yamlText(s.about), kind.name);
  if (kind.knowsMode) text += fmt::format("mode: {}\n", teamPlayModeName(s.mode));
  if (kind.hasRobot && s.player > 0) text += fmt::format("player: {}\n", s.player);
  if (kind.hasRobot) text += "robot: " + poseText(s.robot) + "\n";
  text += own.beforeBall + "ball: [" + rounded(s.ball) + "]\n" + own.afterBall;
  text += "mates: " + othersText(s, true) + "\nopponents: " + othersText(s, false) + "\n" + own.afterOthers;
  return s.expected ? text + "expected: " + s.expected->text() + "\n" : text;
}

}  // namespace plumbline
