#pragma once
#include "gap/replay/Replay.h"

namespace plumbline::gap {

/// Whether the plant does not come to rest by its own law: a servo that feels the link behind a gear with
/// play hunts between the flanks, and where it is in that no recording tells. So does what swings free in
/// wide play and bounces, whichever side the encoder is on.
bool hunts(const JointPlant& joint);
bool anyHunts(const Plant& plant);

/// What a plant would have measured, as far as that can be foretold: the replay alone where nothing hunts;
/// else the mean of several, with other phases of the hunting and other flanks (nobody knows how hard a
/// gear's teeth are), and the variance among them in Prediction::scatter, over a quarter of a second to each
/// side. Of it as little counts as the residual is slower than hunting is: a joint that drifts away does not
/// hunt.
Prediction replayForetold(const Plant& plant, const Trial& trial, const ReplayOptions& options);

}  // namespace plumbline::gap
