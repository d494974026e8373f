#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// A way to play the ball that the striker compared, at the direction that is best for it.
struct StrikerOption : public Streamable {
  std::string action;       ///< name of the kick, or "dribble"
  Vec2 end = Vec2::Zero();  ///< where a ball in the middle of the scatter ends, team's frame [m]
  double value = 0;         ///< of the action, see FieldValue; -1 to 1, a little more if a goal is likely
  double goal = 0;          ///< probability that the ball goes in
  void stream(InStream* in, OutStream* out) override {
    STREAM(action);
    STREAM(end);
    STREAM(value);
    STREAM(goal);
  }
};

/// What the striker decided in this cycle, and what it decided against.
REPRESENTATION(StrikerDecision)
class StrikerDecision : public StrikerDecisionBase {
public:
  static constexpr std::size_t maxOptions = 4;

  bool valid = false;                  ///< it plays the ball now
  Vec2 ball = Vec2::Zero();            ///< where the ball is played, team's frame [m]
  std::vector<StrikerOption> options;  ///< at most maxOptions: the chosen one, then others by value
  void stream(InStream* in, OutStream* out) override {
    STREAM(valid);
    STREAM(ball);
    STREAM(options);
  }
};

}  // namespace plumbline
