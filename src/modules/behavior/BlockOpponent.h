#pragma once
#include "framework/Module.h"
#include "representations/behavior/BlockPosition.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OppInfo.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

MODULE(BlockOpponent)
  REQUIRES(FieldDimensions)
  REQUIRES(BallPos)
  REQUIRES(OtherRobots)
  REQUIRES_IF_PROVIDED(OppInfo)
  PROVIDES(BlockPosition)
  PARAMETER(double, atBall, 1.5, "m", Range(0.1, 10), "an opponent this near to the ball is the striker's")
  PARAMETER(double, passReach, 9, "m", Range(1, 40),
            "a ball is passed so far at most, unless opponents were seen to kick farther")
  PARAMETER(double, goalReach, 13, "m", Range(1, 40), "from farther away no opponent threatens the own goal")
  PARAMETER(double, distance, 0.9, "m", Range(0.3, 5), "the blocker's from the opponent")
END_MODULE

/// Finds the opponent that a pass would make most dangerous, and the place from which a supporter blocks it:
/// before it, between its ways to the ball and to the own goal (Seekircher 2015, A.3).
class BlockOpponent : public BlockOpponentBase {
public:
  void update(BlockPosition* theBlockPosition) override;

private:
  double reachOfPasses() const;
};

}  // namespace plumbline
