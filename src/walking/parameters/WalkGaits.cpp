#include "walking/parameters/WalkGaits.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace plumbline::walking {
namespace {

// So a pointer to gaits is also a pointer to their base.
static_assert(std::is_standard_layout_v<WalkGaits>);

/// The groups of WalkParameters with what may differ between gaits.
const ParameterList& blendingList() {
  static std::deque<ParameterList> groups;
  static const ParameterList list = [] {
    ParameterList all;
    for (const ParameterList::Entry& group : WalkParameters::parameterList().entries()) {
      ParameterList blending;
      for (const ParameterList::Entry& entry : group.group->entries())
        if (entry.parameter.has("blends")) blending.add(entry.parameter, entry.pointer);
      if (blending.empty()) continue;
      groups.push_back(std::move(blending));
      all.addGroup(group.parameter.name, group.parameter.comment, groups.back(), group.groupOf);
    }
    return all;
  }();
  return list;
}

template <std::size_t i>
void* cornerOf(void* gaits) {
  return &static_cast<WalkGaits*>(gaits)->corner[i];
}

const ParameterList& gaitsList() {
  static const ParameterList list = [] {
    ParameterList all;
    const ParameterList& blending = blendingList();
    all.addGroup("forward", "what differs at full speed forward", blending, &cornerOf<0>);
    all.addGroup("backward", "what differs at full speed backward", blending, &cornerOf<1>);
    all.addGroup("sideways", "what differs at full speed sideways", blending, &cornerOf<2>);
    all.addGroup("turn", "what differs at full speed in turning", blending, &cornerOf<3>);
    all.addGroup("recovery", "what differs while the robot recovers from a push; nan: nothing", blending,
                 [](void* gaits) -> void* { return &static_cast<WalkGaits*>(gaits)->recovery; });
    return all;
  }();
  return list;
}

}  // namespace

WalkGaits::WalkGaits(const WalkParameters& all) : base(all) {
  corner.fill(all);
  clearRecovery();
}

const ParameterList& WalkGaits::parameterList() {
  static const ParameterList list = [] {
    ParameterList all;
    for (const ParameterList::Entry& group : WalkParameters::parameterList().entries())
      all.addGroup(group.parameter.name, group.parameter.comment, *group.group, group.groupOf);
    all.addGroup(
        "gaits",
        "what differs at full speed (forward, backward, sideways, turn) and while recovering (recovery)",
        gaitsList(), [](void* gaits) -> void* { return gaits; });
    return all;
  }();
  return list;
}

WalkParameters WalkGaits::at(const Vec2& velocity, double turn, double recovering) const {
  // Up to the omnidirectional limits the robot walks the base.
  const auto beyond = [](double speed, double omni, double full) {
    const double from = omni > 0 ? std::min(omni, full) : 0;
    return from < full ? std::clamp((speed - from) / (full - from), 0.0, 1.0) : 0.0;
  };
  const SpeedParameters& limits = base.speed;
  std::array<double, numCorners> share{
      beyond(velocity.x(), limits.omniForward, limits.maxForward),
      beyond(-velocity.x(), limits.omniBackward, limits.maxBackward),
      beyond(std::abs(velocity.y()), limits.omniSideways, limits.maxSideways),
      beyond(std::abs(turn), limits.omniTurn, limits.maxTurn)};
  double sum = 0;
  for (const double s : share) sum += s;
  if (sum > 1)
    for (double& s : share) s /= sum;
  WalkParameters blended = base;
  for (const WalkParameter& one : walkParameters()) {
    if (!one.blends) continue;
    double& value = one.of(blended);
    const double spot = value;
    for (std::size_t i = 0; i < numCorners; ++i) value += share[i] * (one.of(corner[i]) - spot);
    const double wanted = one.of(recovery);
    if (recovering > 0 && !std::isnan(wanted)) value += recovering * (wanted - value);
  }
  return blended;
}

void WalkGaits::setBase(const WalkParameter& parameter, double value) {
  const double before = parameter.of(base);
  parameter.of(base) = value;
  for (WalkParameters& one : corner)
    if (parameter.of(one) == before) parameter.of(one) = value;
}

void WalkGaits::clearRecovery() {
  for (const WalkParameter& one : walkParameters())
    one.of(recovery) = std::numeric_limits<double>::quiet_NaN();
}

void WalkGaits::openLoop() {
  const auto open = [](WalkParameters& p) {
    for (const WalkParameter& one : walkParameters())
      if (one.declared->has("feedback")) one.of(p) = 0;
  };
  open(base);
  for (WalkParameters& one : corner) open(one);
  clearRecovery();
  base.recovery.full = 0;
  base.recovery.captureMargin = 1;
}

void WalkGaits::check() const {
  base.check();
  const auto checkPart = [](const std::string& name, const WalkParameters& part) {
    try {
      part.check();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(name + ": " + error.what());
    }
  };
  for (std::size_t i = 0; i < numCorners; ++i) checkPart(cornerNames[i], corner[i]);
  checkPart("recovery", at(Vec2::Zero(), 0, 1));
}

}  // namespace plumbline::walking
