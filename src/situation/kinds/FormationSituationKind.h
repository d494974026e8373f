#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "situation/Situation.h"

namespace plumbline {

/// Who goes to the ball, and the role and the place of the player that is asked.
class FormationExpected : public ExpectedDecision {
public:
  enum class Role { goalie, striker, supporter };

  std::string text() const override;
  std::string words(int player) const override;
  std::vector<Vec2> places(const Situation& situation, const FieldSize& field) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  static constexpr std::array<const char*, 3> roleNames = {"goalie", "striker", "supporter"};  ///< in files
  int striker = 0;
  Role role = Role::supporter;
  std::optional<std::array<double, 4>> area{};  ///< x from, to, y from, to [m]
};

}  // namespace plumbline
