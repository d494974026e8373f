#pragma once
#include <vector>

#include "tactics/FieldValueLearner.h"
#include "watch/TrackReader.h"

namespace plumbline::watch {

constexpr double learningStep = 3;  ///< of the game's clock, for learnFromTrack [s]

/// Adds the ball's motion from each moment of a game to `learningStep` later to the learner, as the left team
/// sees it. The places of all players decide which team is nearer; a fallen player is slower. Out of play the
/// ball belongs to the team that restarts. Returns the number of steps and goals that were added.
std::size_t learnFromTrack(const std::vector<TrackMoment>& moments, FieldValueLearner& learner);

}  // namespace plumbline::watch
