#pragma once
#include <string>

#include "framework/Module.h"
#include "modules/evaluation/PlayerFile.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(OthersEvaluation)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(PlayerInfo)
  REQUIRES(RobotPose)
  REQUIRES(LocalBallPos)
  REQUIRES(BallPos)
  REQUIRES(LocalOtherRobots)
  REQUIRES(OtherRobots)
  PARAMETER(std::string, folder, "build/run/others", "", Range(), "of the files, one of each player")
  PARAMETER(double, interval, 0.5, "s", Range(0.02, 60), "of the game's clock from line to line")
END_MODULE

/// Writes this player's estimates of the ball and other robots while the clock of the game runs, for
/// comparison with bin/watchgame --track. Columns: time, belief (alone: own sight; team: with messages of
/// mates), what (ball, mate, opponent), number, x, y, standard deviation, distance, age. Runs only if
/// modules.cfg names it.
class OthersEvaluation : public OthersEvaluationBase {
public:
  OthersEvaluation();
  void init() override;
  void execute() override;

private:
  void add(const char* belief, const char* what, int number, const Vec2& place, double deviation, double age);
  void addRobots(const char* belief, const std::vector<OtherRobot>& robots);

  PlayerFile file_;
  std::string lines_;             ///< of this moment
  double next_ = 0, before_ = 0;  ///< [s]
};

}  // namespace plumbline
