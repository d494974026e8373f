#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Whoever took a restart must not be the next to touch the ball, but for a tenth of a second that the kick
/// may last: otherwise the opponents get an indirect free kick where the ball is. True if so.
/// (CheckFreeKickTakerFoul, PunishFreeKickFoul)
bool doubleTouch(Match& match);

/// The player that touched the ball last took a restart.
void kickTaken(Match& match, bool indirect);
/// Nobody has taken a restart, nor is anyone in or after a pass mode. (ResetKickChecks)
void forgetKick(Match& match);
/// Whether nobody has touched the ball since the kick of the last restart.
bool stillFromKick(Match& match);

}  // namespace plumbline::simulation
