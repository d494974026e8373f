#pragma once
#include <deque>

#include "simspark/SceneFoul.h"

namespace plumbline::simulation {

/// A breach of the rules; its index counts from 1.
struct Foul : simspark::SceneFoul {
  using Kind = simspark::FoulKind;
};

/// The fouls of a game; the oldest are forgotten, as a game for training may last for days.
class Fouls {
public:
  static constexpr std::size_t kept = 256;

  void add(Foul::Kind kind, simspark::TeamSide side, int unum) {
    recent_.push_back({{++count_, kind, side, unum}});
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
