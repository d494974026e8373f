#pragma once
#include "framework/Module.h"
#include "modules/behavior/setpiece/SetPieces.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/SetPieceOutput.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(SetPieceTaker)
  REQUIRES(GameState)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(FieldDimensions)
  REQUIRES(PlayerRole)
  REQUIRES(OtherRobots)
  PROVIDES(SetPieceOutput)
  PARAMETER(double, ballMaxAge, 3, "s", Range(0.1, 60),
            "a ball that was not seen for longer is left to others")
  PARAMETER(double, farOpponent, 3, "m", Range(0.1, 20),
            "an opponent farther from the ball's way does not matter")
  PARAMETER(double, reception, 0.4, "", Range(0, 5),
            "what a metre between the ball's end and the next mate costs, in metres of free way")
  PARAMETER(double, tolerance, 0.15, "rad", Range(0.01, 1), "a kick may go so far aside, to either side")
  PARAMETER(double, changeMargin, 0.5, "m", Range(0, 10),
            "another kick must be better by this to replace the last choice")
END_MODULE

/// The striker of a team in the set pieces of config/set_pieces/: it kicks where the way is free and a mate
/// is near, or waits where the file says. Inactive if no file has the play mode, and for a robot alone.
class SetPieceTaker : public SetPieceTakerBase {
public:
  void init() override;
  void update(SetPieceOutput* theSetPieceOutput) override;

private:
  Vec2 at(const SetPiecePlace& place) const;
  double worth(const Vec2& end) const;
  const SetPiecePlace* chooseKick(const SetPiece& piece);
  void draw(const SetPiece& piece, const Vec2& target) const;

  SetPieces pieces_;
  SetPieceSide side_;
  const SetPiecePlace* chosen_ = nullptr;
};

}  // namespace plumbline
