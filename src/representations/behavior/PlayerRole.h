#pragma once
#include "framework/Representation.h"
#include "math/Pose2.h"

namespace plumbline {

/// What this player is for in its team now.
REPRESENTATION(PlayerRole)
class PlayerRole : public PlayerRoleBase {
public:
  static constexpr int none = 0, goalie = 1, striker = 2, supporter = 3;
  /// A timeToBall for who must not touch the ball or does not know it [s]; longer times count as this.
  static constexpr double never = 16;

  int role = none;             ///< supporter + i: at the i-th place of config/formation.yaml
  bool keeper = false;         ///< the team's goalie, also while its role is the striker's
  Pose2 place;                 ///< where a supporter shall be, team's frame [m, rad]
  int strikerNumber = 0;       ///< who goes to the ball, 0: nobody known
  double timeToBall = never;   ///< of this player [s]
  bool mayTouchBall = true;    ///< false: it took a restart, and another one has to touch the ball first
  bool mayBeInOwnArea = true;  ///< false: the rules allow no more players in the own penalty area
  int members = 0;             ///< players of the team that are known to play, this one among them
  bool supports() const { return role >= supporter; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(role);
    STREAM(keeper);
    STREAM("placePosition", place.position);
    STREAM("placeHeading", place.heading);
    STREAM(strikerNumber);
    STREAM(timeToBall);
    STREAM(mayTouchBall);
    STREAM(mayBeInOwnArea);
    STREAM(members);
  }
};

}  // namespace plumbline
