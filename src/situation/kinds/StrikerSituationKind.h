#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "robot/KickEffect.h"
#include "situation/Situation.h"

namespace plumbline {

/// What only a striker's situations have.
struct StrikerKnowledge : KindKnowledge {
  std::vector<KickEffect> kicks{};
};

/// The striker plays the ball in a direction between two [rad], by a kick that carries so far [m].
class StrikerExpected : public ExpectedDecision {
public:
  enum class Action { any, kick, dribble };

  std::string text() const override;
  std::string words(int player) const override;
  std::vector<Vec2> places(const Situation& situation, const FieldSize& field) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  static constexpr std::array<const char*, 3> actionNames = {"any", "kick", "dribble"};  ///< in files
  Action action = Action::any;
  Vec2 direction = Vec2::Zero();
  std::optional<Vec2> reach{};
};

}  // namespace plumbline
