#include "training/WalkChoice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/Random.h"

namespace plumbline::training {
namespace {

bool same(const walking::WalkParameters& a, const walking::WalkParameters& b) {
  return std::ranges::all_of(walking::walkParameters(),
                             [&](const walking::WalkParameter& one) { return one.of(a) == one.of(b); });
}

}  // namespace

walking::WalkGaits withSprint(const walking::WalkGaits& gaits, const walking::WalkGaits& other,
                              WalkTrialKind direction) {
  const SprintSpeeds d = speedsOf(direction);
  walking::WalkGaits result = gaits;
  result.corner[static_cast<std::size_t>(direction)] = other.corner[static_cast<std::size_t>(direction)];
  result.base.speed.*d.most = other.base.speed.*d.most;
  for (walking::WalkParameters& corner : result.corner) corner.speed.*d.most = other.base.speed.*d.most;
  return result;
}

walking::WalkGaits slowMixture(const walking::WalkGaits& gaits, double share) {
  walking::WalkGaits slow = gaits;
  for (const WalkTrialKind task : sprintDirections) {
    const SprintSpeeds direction = speedsOf(task);
    slow.base.speed.*direction.omni *= share;
    for (walking::WalkParameters& corner : slow.corner)
      corner.speed.*direction.omni = slow.base.speed.*direction.omni;
  }
  return slow;
}

double randomFalls(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup, double enough) {
  double falls = 0;
  for (int i = 0; i < setup.minutes; ++i) {
    WalkTrialSetup trial;
    trial.seed = setup.seed * 1000 + static_cast<std::uint64_t>(i);
    trial.tries = 1;
    trial.seconds = 60;
    trial.push = 0;
    trial.stopEarly = false;
    falls += tryWalk(robot, gaits, WalkTrialKind::mixture, trial).falls;
    if (falls > enough * setup.minutes) break;
  }
  return falls / setup.minutes;
}

namespace {

/// The i-th of the times a sprint is held.
HeldSpeed hold(Walker& robot, WalkTrialKind direction, double seconds, int i, const ChoiceSetup& setup) {
  Random random(setup.seed * 1000 + static_cast<std::uint64_t>(i));
  return holdSpeed(robot, fullSpeed(direction, i % 2 == 0 ? 1 : -1), seconds, random.uniform(0.1, 0.6), 0);
}

/// Of a sprint that holds, mean over the beginnings of the times it is held; 0 where it does not.
double heldSpeed(Walker& robot, WalkTrialKind direction, const ChoiceSetup& setup) {
  double sum = 0;
  for (int i = 0; i < setup.holds; ++i) {
    const HeldSpeed held = hold(robot, direction, std::min(20.0, setup.holdSeconds), i, setup);
    if (!held.upright) return 0;
    sum += held.speed;
  }
  return sum / setup.holds;
}

}  // namespace

bool sprintHolds(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind direction,
                 const ChoiceSetup& setup) {
  // What fails most often comes first.
  for (int i = 0; i < setup.tries; ++i) {
    WalkTrialSetup trial;
    trial.seed = setup.seed * 1000 + static_cast<std::uint64_t>(i);
    trial.tries = 1;
    trial.seconds = setup.trySeconds;
    trial.push = setup.push;
    if (tryWalk(robot, gaits, direction, trial).falls > 0) return false;
  }
  robot.use(gaits);
  for (int i = 0; i < setup.holds; ++i)
    if (!hold(robot, direction, setup.holdSeconds, i, setup).upright) return false;
  return true;
}

double safeShare(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind direction,
                 const ChoiceSetup& setup) {
  const int steps = static_cast<int>(std::lround(1 / setup.sprintStep));
  for (int i = steps; i > 0; --i) {
    const double share = std::min(1.0, i * setup.sprintStep);
    if (sprintHolds(robot, cutSprint(gaits, direction, share), direction, setup)) return share;
  }
  return 0;
}

walking::WalkGaits chooseMixture(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup,
                                 const std::function<void(const std::string&)>& say) {
  const int last = static_cast<int>(std::lround(0.5 / setup.mixStep));
  double share = 1;
  for (int i = 0; i <= last; ++i, share -= setup.mixStep) {
    walking::WalkGaits slow = slowMixture(gaits, share);
    const double falls = randomFalls(robot, cutSprints(slow, 0), setup, 0);
    say(fmt::format("mixture at {:.2f} of its speeds: {}", share, falls > 0 ? "falls" : "no fall"));
    if (falls == 0) return slow;
  }
  return slowMixture(gaits, 0.5);
}

walking::WalkGaits chooseSprint(Walker& robot, const walking::WalkGaits& gaits,
                                const std::vector<walking::WalkGaits>& others, WalkTrialKind direction,
                                const ChoiceSetup& setup,
                                const std::function<void(const std::string&)>& say) {
  const SprintSpeeds d = speedsOf(direction);
  const auto corner = static_cast<std::size_t>(direction);
  walking::WalkGaits best = gaits;
  double fastest = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const walking::WalkGaits& other = others[i];
    // A search that found nothing better returns what there was.
    if (std::any_of(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(i),
                    [&](const walking::WalkGaits& o) {
                      return o.base.speed.*d.most == other.base.speed.*d.most &&
                             same(o.corner[corner], other.corner[corner]);
                    }))
      continue;
    walking::WalkGaits tried = withSprint(gaits, other, direction);
    const double share = safeShare(robot, tried, direction, setup);
    tried = cutSprint(tried, direction, share);
    robot.use(tried);
    const double speed = heldSpeed(robot, direction, setup);
    say(fmt::format("{}: {:.2f} of the sprint holds, {:.3f} {}", walkTrialKindNames[corner], share, speed,
                    direction == WalkTrialKind::turn ? "rad/s" : "m/s"));
    if (speed <= fastest) continue;
    fastest = speed;
    best = tried;
  }
  return best;
}

walking::WalkGaits chooseTogether(Walker& robot, const walking::WalkGaits& gaits, const ChoiceSetup& setup,
                                  const std::function<void(const std::string&)>& say) {
  walking::WalkGaits cut = gaits;
  const int steps = static_cast<int>(std::lround(1 / setup.sprintStep));
  double share = 1;
  for (int i = 1; i < steps; ++i, share -= setup.sprintStep) {
    cut = cutSprints(gaits, share);
    const double falls = randomFalls(robot, cut, setup, setup.fallsPerMinute);
    say(fmt::format("all sprints at {:.2f}: {:.3f} falls a minute{}", share, falls,
                    falls > setup.fallsPerMinute ? " at least" : ""));
    if (falls <= setup.fallsPerMinute) return cut;
  }
  return cutSprints(gaits, 0);
}

}  // namespace plumbline::training
