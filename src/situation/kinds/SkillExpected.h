#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/ConfigSection.h"
#include "situation/Situation.h"

namespace plumbline {

/// A supporter or the taker of a set piece uses a skill.
class SkillExpected : public ExpectedDecision {
public:
  /// With a heading the target is [x, y, heading] and may be missing, without one it is [x, y].
  static std::shared_ptr<const SkillExpected> read(const ConfigSection& section, bool hasHeading);

  std::string text() const override;
  std::string words(int player) const override;
  std::vector<Vec2> places(const Situation& situation, const FieldSize& field) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  std::string skill{};           ///< see Skill
  std::optional<Vec2> target{};  ///< of the player, or of the ball if it is kicked [m]
  std::optional<double> heading{};
  double within = 0;  ///< [m, rad]
};

}  // namespace plumbline
