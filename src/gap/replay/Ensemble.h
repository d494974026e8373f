#pragma once
#include "gap/replay/Replay.h"

namespace plumbline::gap {

/// Whether the plant never comes to rest by its own law. A servo whose encoder is behind a gear with backlash
/// swings between the flanks of the teeth: a limit cycle, whose phase no recording shows. A link that swings
/// free in wide backlash bounces, whichever side the encoder is on.
bool hasLimitCycle(const JointPlant& joint);
bool anyLimitCycle(const Plant& plant);

/// Prediction of what a plant measures, where limit cycles make it uncertain. Without a limit cycle: one
/// replay. Otherwise the mean of several replays, which differ in the phase of the limit cycle and in the
/// stiffness of the teeth, which nobody knows. Their variance, over a quarter of a second to each side, is in
/// Prediction::scatter. It is scaled down where the residual varies more slowly than the limit cycle: a joint
/// that drifts away has none.
Prediction predictEnsemble(const Plant& plant, const Trial& trial, const ReplayOptions& options);

}  // namespace plumbline::gap
