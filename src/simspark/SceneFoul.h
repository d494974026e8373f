#pragma once
#include <optional>

#include "simspark/SExpression.h"
#include "simspark/TeamSide.h"

namespace plumbline::simspark {

/// In the league's order; nothing counts as illegalAttack or kickOff there.
enum class FoulKind {
  crowding,
  touching,
  illegalDefence,
  illegalAttack,
  incapable,
  kickOff,
  charging,
  selfCollision,
  none
};

/// A breach of the rules, as monitors get it: (foul INDEX KIND SIDE UNUM), SIDE 1 left, 2 right.
struct SceneFoul {
  int index = 0;  ///< from 1
  FoulKind kind = FoulKind::none;
  TeamSide side = TeamSide::none;
  int unum = 0;
};

/// From a list (foul ...). Nothing if a number is missing, or is none that a foul has.
std::optional<SceneFoul> readFoul(SExpressions::Node list);

}  // namespace plumbline::simspark
