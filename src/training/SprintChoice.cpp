#include "training/SprintChoice.h"

#include <cmath>
#include <stdexcept>

#include "math/Random.h"

namespace plumbline::walking {
namespace {

struct Direction {
  double WalkParameters::*most;
  double WalkParameters::*mixed;
};

Direction directionOf(Task task) {
  switch (task) {
    case Task::forward:
      return {&WalkParameters::maxForward, &WalkParameters::mixForward};
    case Task::backward:
      return {&WalkParameters::maxBackward, &WalkParameters::mixBackward};
    case Task::sideways:
      return {&WalkParameters::maxSideways, &WalkParameters::mixSideways};
    case Task::turn:
      return {&WalkParameters::maxTurn, &WalkParameters::mixTurn};
    case Task::mixture:
      break;
  }
  throw std::invalid_argument("a mixture of directions has no sprint");
}

}  // namespace

WalkGaits cutSprint(const WalkGaits& gaits, Task direction, double share) {
  const auto [most, mixed] = directionOf(direction);
  WalkGaits cut = gaits;
  WalkParameters& corner = cut.corner[static_cast<std::size_t>(direction)];
  const double mix = gaits.base.*mixed;
  // Without a speed of mixtures there is no sprint.
  if (!(mix > 0 && mix < gaits.base.*most)) return cut;
  const double full = mix + share * (gaits.base.*most - mix);
  cut.base.*most = full;
  for (WalkParameters& one : cut.corner) one.*most = full;
  for (const WalkParameterInfo& info : walkParameterTable()) {
    if (!info.blends) continue;
    const double from = gaits.base.*info.value;
    corner.*info.value = from + share * (corner.*info.value - from);
  }
  return cut;
}

bool holds(Walker& robot, const WalkGaits& gaits, Task direction, const ChoiceSetup& setup) {
  // What fails most often comes first.
  for (int i = 0; i < setup.tries; ++i) {
    TrialSetup trial;
    trial.seed = setup.seed * 1000 + static_cast<std::uint64_t>(i);
    trial.tries = 1;
    trial.seconds = setup.trySeconds;
    trial.push = setup.push;
    if (tryWalk(robot, gaits, direction, trial).falls > 0) return false;
  }
  robot.use(gaits);
  for (int i = 0; i < setup.holds; ++i) {
    Random random(setup.seed * 1000 + static_cast<std::uint64_t>(i));
    if (!holdSpeed(robot, fullSpeed(direction, i % 2 == 0 ? 1 : -1), setup.holdSeconds,
                   random.uniform(0.1, 0.6))
             .upright)
      return false;
  }
  return true;
}

double safeShare(Walker& robot, const WalkGaits& gaits, Task direction, const ChoiceSetup& setup) {
  const int steps = static_cast<int>(std::lround(1 / setup.step));
  for (int i = steps; i > 0; --i) {
    const double share = std::min(1.0, i * setup.step);
    if (holds(robot, cutSprint(gaits, direction, share), direction, setup)) return share;
  }
  return 0;
}

}  // namespace plumbline::walking
