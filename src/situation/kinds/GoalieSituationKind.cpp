#include "situation/kinds/GoalieSituationKind.h"

#include <fmt/format.h>

#include "situation/Rounded.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationKinds.h"
#include "situation/SituationValues.h"

namespace plumbline {
namespace {

constexpr double fastestBall = 30;  // [m/s]

class GoalieSituationKind : public SituationKind {
public:
  GoalieSituationKind()
      : SituationKind({.name = "goalie", .order = 20, .heading = "The goalie: where it stands"}) {}

  void read(const ConfigSection& root, Situation& situation) const override {
    situation.ballVelocity = root.get<Vec2>("velocity", Range(-fastestBall, fastestBall));
  }

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    auto expected = std::make_shared<GoalieExpected>();
    expected->place = section.get<Vec2>("place", SituationLimits::places());
    expected->within = section.get<double>("within", SituationLimits::distances());
    expected->fromTheWay = section.find<double>("fromTheWay", SituationLimits::distances());
    return expected;
  }

  KindText text(const Situation& situation) const override {
    return {.afterBall = "velocity: [" + rounded(situation.ballVelocity) + "]\n"};
  }
};

MAKE_SITUATION_KIND(GoalieSituationKind)

}  // namespace

std::string GoalieExpected::text() const {
  return fmt::format("{{place: [{}], within: {}{}}}", rounded(place), rounded(within),
                     fromTheWay ? ", fromTheWay: " + rounded(*fromTheWay) : "");
}

std::string GoalieExpected::words(int /*player*/) const {
  return fmt::format(
      "goes to {} within {} m{}", placeWords(place), rounded(within),
      fromTheWay ? fmt::format(", at most {} m from the ball's way", rounded(*fromTheWay)) : "");
}

std::vector<Vec2> GoalieExpected::places(const Situation&, const FieldSize&) const { return {place}; }

void GoalieExpected::draw(const Situation& situation, const FieldSize&, SituationCanvas& canvas) const {
  canvas.way(situation.robot.position, place, within, "goes here");
}

}  // namespace plumbline
