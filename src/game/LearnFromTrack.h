#pragma once
#include <vector>

#include "game/TrackReader.h"
#include "tactics/FieldValueLearner.h"

namespace plumbline::game {

constexpr double learningStep = 3;  ///< of the game's clock, for learnFromTrack [s]

/// Tells the learner what the ball did from each moment of a game to `learningStep` later, as the left team
/// sees it. Who is nearer follows from everybody's place; a fallen player counts later. Out of play the ball
/// belongs to the team whose restart it is. Returns the number of steps and goals that it has told.
std::size_t learnFromTrack(const std::vector<TrackMoment>& moments, FieldValueLearner& learner);

}  // namespace plumbline::game
