#include "watch/LearnFromTrack.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/ExpectedRobot.h"

namespace plumbline::watch {
namespace {

constexpr double farTime = 30;  ///< no team needs longer, nor one without players [s]
constexpr double gap = 0.8;     ///< moments farther apart are not of one course [s]

double timeToBall(const TrackMoment& moment, bool left) {
  double best = farTime;
  for (const TrackPlayer& player : moment.players)
    if (player.left == left)
      best = std::min(best, (player.place - moment.ball).norm() / expectedWalkSpeed +
                                (player.stands ? 0.0 : expectedGetUpSeconds));
  return best;
}

enum class Phase { play, left, right, goalLeft, goalRight, none };

/// What a play mode means for the ball: in play, a team's restart or goal.
Phase phaseOf(const std::string& mode) {
  if (mode == "PlayOn") return Phase::play;
  const bool left = mode.ends_with("_Left") || mode.ends_with("_left");
  if (!left && !mode.ends_with("_Right") && !mode.ends_with("_right")) return Phase::none;
  if (mode.starts_with("Goal_") || mode.starts_with("goal_left") || mode.starts_with("goal_right"))
    return left ? Phase::goalLeft : Phase::goalRight;
  if (mode.starts_with("KickOff")) return Phase::none;
  return left ? Phase::left : Phase::right;
}

std::optional<BallState> stateOf(const TrackMoment& moment, Phase phase) {
  switch (phase) {
    case Phase::play:
      return BallState{moment.ball, ballAdvantage(timeToBall(moment, true), timeToBall(moment, false))};
    case Phase::left:
      return BallState{moment.ball, 1};
    case Phase::right:
      return BallState{moment.ball, -1};
    default:
      return std::nullopt;
  }
}

}  // namespace

std::size_t learnFromTrack(const std::vector<TrackMoment>& moments, FieldValueLearner& learner) {
  std::size_t counted = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Phase here = phaseOf(moments[i].mode);
    const auto from = stateOf(moments[i], here);
    if (!from) continue;
    for (std::size_t j = i + 1; j < moments.size() && moments[j].time - moments[j - 1].time < gap; ++j) {
      const Phase there = phaseOf(moments[j].mode);
      if (there == Phase::none) break;
      if (there == Phase::goalLeft || there == Phase::goalRight) {
        learner.addGoal(*from, there == Phase::goalLeft);
        ++counted;
        break;
      }
      if (moments[j].time - moments[i].time < learningStep - 1e-6) continue;
      learner.addStep(*from, *stateOf(moments[j], there));
      ++counted;
      break;
    }
  }
  return counted;
}

}  // namespace plumbline::watch
