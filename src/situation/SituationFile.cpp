#include "situation/SituationFile.h"

#include <fmt/format.h>

#include "framework/ConfigFile.h"
#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

constexpr std::size_t mostWords = 400;

void readOthers(const ConfigSection& root, Situation& situation) {
  for (const bool mate : {true, false}) {
    const char* key = mate ? "mates" : "opponents";
    for (const auto& row : readRows(root, key, 2, 3, "[x, y] or [x, y, number]")) {
      OtherRobot& robot = situation.others.emplace_back();
      robot.mate = mate;
      robot.position = {row[0], row[1]};
      robot.number = row.size() > 2 ? playerNumber(root, key, row[2]) : 0;
    }
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
  const SituationKind& kind = *situationKinds().at(root.choice("decides", situationKindNames()));
  situation.kind = &kind;
  if (kind.traits.knowsMode && root.has("mode"))
    situation.mode = readChoice<TeamPlayMode>(root, "mode", teamPlayModeNames);
  if (kind.traits.hasRobot)
    situation.player = root.find<int>("player", SituationLimits::numbers()).value_or(0);
  situation.ball = root.get<Vec2>("ball", SituationLimits::places());
  readOthers(root, situation);
  if (kind.traits.hasRobot) situation.robot = readPose(root, "robot");
  kind.read(root, situation);
  if (root.has("expected")) situation.expected = kind.readExpected(root.section("expected"));
  file.checkUnknown();
  return situation;
}

}  // namespace plumbline
