#include "gap/diagnosis/UnderLoad.h"

#include <algorithm>

#include "gap/diagnosis/DeviatingJoints.h"

namespace plumbline::gap {

namespace {

constexpr double notClean = 3;        // noise variances of the worst joint, beyond noise
constexpr double motorShare = 0.3;    // of that: what a joint with a weak motor is off by at least
constexpr std::size_t mostFound = 2;  // causes: with as many found, nothing is looked for any more

}  // namespace

UnderLoad::UnderLoad(const Evaluator& evaluator) : robot_(evaluator.mechanism()) {
  if (!evaluator.hasFixedBase() || !evaluator.hasFloatingBase() || evaluator.base().size() >= mostFound)
    return;
  if (DeviatingJoints(evaluator).any) return;
  excess_ = jointExcess(evaluator, true);
  worst_ = *std::ranges::max_element(excess_);
  for (const auto& foot : robot_.feet)
    for (const int joint : robot_.chain(foot.link)) legs_.insert(joint);
}

bool UnderLoad::shows(const Effect& effect, const Place& place) const {
  if (!(worst_ > notClean)) return false;
  if (place.site == Site::link) {
    const std::vector<int> chain = robot_.chain(place.index);
    return !chain.empty() && legs_.contains(chain.back());
  }
  if (place.site != Site::joint || !legs_.contains(place.index)) return false;
  switch (effect.screening.underLoad) {
    case Screening::UnderLoad::anyLeg:
      return true;
    case Screening::UnderLoad::weakMotor:
      return excess_[static_cast<std::size_t>(place.index)] > motorShare * worst_;
    case Screening::UnderLoad::no:
      break;
  }
  return false;
}

}  // namespace plumbline::gap
