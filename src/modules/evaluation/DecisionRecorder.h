#pragma once
#include <string>

#include "framework/Module.h"
#include "modules/evaluation/PlayerFile.h"
#include "representations/behavior/StrikerDecision.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameState.h"
#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

/// Where DecisionRecorder writes; main gives it to the module's objects. Without such an object, nowhere.
struct DecisionOptions {
  std::string folder;
};

MODULE(DecisionRecorder)
  REQUIRES(FrameInfo)
  REQUIRES(GameState)
  REQUIRES(PlayerInfo)
  REQUIRES(StrikerDecision)
  PARAMETER(double, interval, 0.2, "s", Range(0.02, 60), "lines follow each other no sooner")
  PARAMETER(double, again, 1, "s", Range(0.02, 60), "a decision that stays is written again after this time")
  PARAMETER(double, turned, 0.1, "rad", Range(0, 3.2),
            "a ball that shall go so far aside is another decision")
  PARAMETER(int, maxLines, 20000, "", Range(1, 1000000), "of a file; what comes after them is left out")
END_MODULE

/// Writes what the striker decides, and the best of what it decided against, into a file of this player,
/// FOLDER/left-5.csv, where DecisionOptions want it (--decisions). bin/webmonitor --summary reads it.
///
/// Columns: clock of the game [s]; x, y of the ball. Then for the chosen action and up to three others: the
/// kick's name or "dribble"; endX, endY: where the ball ends; value (FieldValue); goal, the probability that
/// it goes in. Team's frame [m]. Columns of others that there are not are empty.
class DecisionRecorder : public DecisionRecorderBase {
public:
  DecisionRecorder();
  void init() override;
  void execute() override;

private:
  bool due() const;
  void write();

  std::string folder_;  ///< empty: nothing is written
  PlayerFile file_;
  int lines_ = 0;
  double written_ = -1e9;  ///< when the last line was [s]
  std::string action_;     ///< in it
  double direction_ = 0;   ///< of the ball in it [rad]
};

}  // namespace plumbline
