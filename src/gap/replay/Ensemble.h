#pragma once
#include "gap/replay/Replay.h"

namespace plumbline::gap {

/// Whether the plant never comes to rest. A servo whose encoder is behind a gear with backlash swings between
/// the flanks of the teeth: this is a limit cycle, and no recording shows its phase. A link that swings
/// freely in wide backlash bounces, whichever side the encoder is on.
bool hasLimitCycle(const JointPlant& joint);
bool anyLimitCycle(const Plant& plant);

/// Prediction of a plant's readings when limit cycles make it uncertain. Without a limit cycle it is one
/// replay. Otherwise it is the mean of several replays with different phases of the limit cycle and different
/// stiffness of the teeth, which are unknown. Their variance, over a quarter of a second to each side, is in
/// Prediction::variance. It is scaled down where the residual varies more slowly than the limit cycle: a
/// joint that drifts away has none.
Prediction predictEnsemble(const Plant& plant, const Trial& trial, const ReplayOptions& options);

}  // namespace plumbline::gap
