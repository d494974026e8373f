#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// A player asks for pass mode. It gets it if play is on, it is 3 s since its team's last one, and nobody of
/// its team touches the ball. The ball must move by at most 0.05 m/s, the player be within 0.5 m of it, and
/// no opponent within 1 m (CanActivatePassMode, StartPassMode). Pass mode lasts 4 s, or until a player
/// touches the ball; opponents are put 1.1 m away from it (UpdatePassMode). For 10 s after pass mode the team
/// may not score. This ends when the ball has left the circle of 1 m around its place in pass mode and two of
/// the team's players have touched it since (UpdatePassModeScoringCheckValues).
class PassMode : public Rule {
public:
  void passAsked(Match& match, const Participant& player) override;
  void play(Match& match) override;
  void afterPlay(Match& match) override;
  void end(Match& match) override;
};

/// How long the side must not score for its pass mode [s]; 0: it may.
double passScoreWait(Match& match, TeamSide side);

}  // namespace plumbline::simulation
