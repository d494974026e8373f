#include "situation/kinds/BlockSituationKind.h"

#include <fmt/format.h>

#include "representations/modeling/OppInfo.h"
#include "situation/CycleOfLog.h"
#include "situation/Rounded.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

std::shared_ptr<const BlockKnowledge> withKickDistance(std::optional<double> distance) {
  auto known = std::make_shared<BlockKnowledge>();
  known->kickDistance = distance;
  return known;
}

class BlockSituationKind : public SituationKind {
public:
  BlockSituationKind()
      : SituationKind({.name = "block",
                       .order = 50,
                       .heading = "Blocks: which opponent, and from where",
                       .hasRobot = false,
                       .ofOnePlayer = false}) {}

  void read(const ConfigSection& root, Situation& situation) const override {
    situation.known = withKickDistance(root.find<double>("kickDistance", SituationLimits::distances()));
  }

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    auto expected = std::make_shared<BlockExpected>();
    expected->opponent = section.get<int>("opponent", SituationLimits::numbers());
    if (expected->opponent == 0) return expected;
    expected->place = section.get<Vec2>("place", SituationLimits::places());
    expected->within = section.get<double>("within", SituationLimits::distances());
    return expected;
  }

  KindText text(const Situation& situation) const override {
    const auto& distance = knownTo<BlockKnowledge>(situation).kickDistance;
    return {.afterBall = distance ? "kickDistance: " + rounded(*distance) + "\n" : ""};
  }

  void take(const CycleOfLog& cycle, Situation& situation) const override {
    const double distance = cycle.get<OppInfo>().kickDistance;
    if (distance > 0) situation.known = withKickDistance(distance);
  }
};

MAKE_SITUATION_KIND(BlockSituationKind)

}  // namespace

std::string BlockExpected::text() const {
  if (opponent == 0) return "{opponent: 0}";
  return fmt::format("{{opponent: {}, place: [{}], within: {}}}", opponent, rounded(place), rounded(within));
}

std::string BlockExpected::words(int /*player*/) const {
  if (opponent == 0) return "nobody is blocked";
  return fmt::format("number {} is blocked from {} within {} m", opponent, placeWords(place),
                     rounded(within));
}

std::vector<Vec2> BlockExpected::places(const Situation&, const FieldSize&) const {
  if (opponent == 0) return {};
  return {place};
}

void BlockExpected::draw(const Situation& situation, const FieldSize&, SituationCanvas& canvas) const {
  if (opponent == 0) return canvas.label(situation.ball, "nobody is blocked");
  canvas.ring(place, within);
  canvas.label(place, fmt::format("blocks {}", opponent));
}

}  // namespace plumbline
