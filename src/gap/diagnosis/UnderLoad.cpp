#include "gap/diagnosis/UnderLoad.h"

#include <algorithm>

#include "gap/diagnosis/DeviatingJoints.h"

namespace plumbline::gap {

namespace {

constexpr double notClean = 3;        // noise variances of the worst joint, beyond noise
constexpr double motorShare = 0.3;    // of that: what a joint with a weak motor is off by at least
constexpr std::size_t mostFound = 2;  // causes: with as many found, nothing is looked for any more

}  // namespace

UnderLoad::UnderLoad(const Evaluator& evaluator) : robot(evaluator.mechanism()) {
  if (!evaluator.hasFixedBase() || !evaluator.hasFloatingBase() || evaluator.base().size() >= mostFound)
    return;
  if (DeviatingJoints(evaluator).any) return;
  excess = jointExcess(evaluator, true);
  worst = *std::ranges::max_element(excess);
  for (const auto& foot : robot.feet)
    for (const int joint : robot.chain(foot.link)) legs.insert(joint);
}

bool UnderLoad::shows(const Effect& effect, const Place& place) const {
  if (!(worst > notClean)) return false;
  if (place.site == Site::link) {
    const std::vector<int> chain = robot.chain(place.index);
    return !chain.empty() && legs.contains(chain.back());
  }
  if (place.site != Site::joint || !legs.contains(place.index)) return false;
  switch (effect.screening.underLoad) {
    case Screening::UnderLoad::anyLeg:
      return true;
    case Screening::UnderLoad::weakMotor:
      return excess[static_cast<std::size_t>(place.index)] > motorShare * worst;
    case Screening::UnderLoad::no:
      break;
  }
  return false;
}

}  // namespace plumbline::gap
