#pragma once
#include <optional>
#include <string>
#include <vector>

#include "situation/Situation.h"

namespace plumbline {

/// What only situations with blocks have.
struct BlockKnowledge : KindKnowledge {
  std::optional<double> kickDistance{};  ///< how far opponents were seen to kick [m]
};

/// Which opponent is blocked, 0: none; and from where.
class BlockExpected : public ExpectedDecision {
public:
  std::string text() const override;
  std::string words(int player) const override;
  std::vector<Vec2> places(const Situation& situation, const FieldSize& field) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  int opponent = 0;
  Vec2 place = Vec2::Zero();
  double within = 0;
};

}  // namespace plumbline
