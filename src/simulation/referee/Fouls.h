#pragma once
#include <deque>

#include "simspark/TeamSide.h"

namespace plumbline::simulation {

/// A breach of the rules, as monitors are told: (foul INDEX KIND SIDE UNUM), SIDE 1 left, 2 right.
struct Foul {
  /// In the league's order; nothing counts as illegalAttack or kickOff there.
  enum class Kind {
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
  int index = 0;  ///< from 1
  Kind kind = Kind::none;
  simspark::TeamSide side = simspark::TeamSide::none;
  int unum = 0;
};

/// The fouls of a game; the oldest are forgotten, as a game for training may last for days.
class Fouls {
public:
  static constexpr std::size_t kept = 256;

  void add(Foul::Kind kind, simspark::TeamSide side, int unum) {
    recent_.push_back({++count_, kind, side, unum});
    if (recent_.size() > kept) recent_.pop_front();
  }
  int count() const { return count_; }
  /// Those with a higher index, the oldest first.
  std::deque<Foul> since(int index) const {
    std::deque<Foul> found;
    for (const Foul& foul : recent_)
      if (foul.index > index) found.push_back(foul);
    return found;
  }

private:
  std::deque<Foul> recent_;
  int count_ = 0;
};

}  // namespace plumbline::simulation
