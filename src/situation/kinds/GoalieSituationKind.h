#pragma once
#include <optional>
#include <string>
#include <vector>

#include "situation/Situation.h"

namespace plumbline {

/// The goalie goes to a place [m].
class GoalieExpected : public ExpectedDecision {
public:
  std::string text() const override;
  std::string words(int player) const override;
  std::vector<Vec2> places(const Situation& situation, const FieldSize& field) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  Vec2 place = Vec2::Zero();
  double within = 0;
  std::optional<double> fromTheWay{};  ///< so near to the way of the ball
};

}  // namespace plumbline
