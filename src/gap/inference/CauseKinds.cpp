#include "gap/inference/CauseKinds.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/PossibleKinds.h"
#include "gap/inference/SettingMask.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double mostUnits = 1e3;  // units

/// Joints whose channels show a cause's sensitivity.
std::vector<int> jointsOf(const Mechanism& robot, const Place& place) {
  switch (place.site) {
    case Site::joint: {
      std::vector<int> joints;
      for (int joint = 0; joint < robot.numJoints(); ++joint)
        if (robot.motorOf(joint) == robot.motorOf(place.index)) joints.push_back(joint);
      return joints;
    }
    case Site::link:
      return robot.chain(place.index);
    case Site::imu:
    case Site::foot:
      return {-1};
    default:
      return {};
  }
}

double middleStart(const Effect& effect, double scale) {
  std::vector<double> strengths;
  for (const double start : effect.starts) strengths.push_back(effect.strengthOf(start * scale));
  std::ranges::stable_sort(strengths, {}, [](double strength) { return std::abs(strength); });
  return strengths[strengths.size() / 2];
}

CauseKind kindOf(const Mechanism& robot, const Cause& cause, double unit) {
  CauseKind kind{cause, unit, 0, 0, jointsOf(robot, cause.place)};
  const Bounds bounds = cause.effect->boundsAt(robot, cause.place);
  const double one = cause.effect->strengthOf(bounds.lower) / kind.unit,
               other = cause.effect->strengthOf(bounds.upper) / kind.unit;
  kind.lower = std::clamp(std::min(one, other), -mostUnits, 0.0);
  kind.upper = std::clamp(std::max(one, other), 0.0, mostUnits);
  kind.cause = causeAt(robot, kind, 1);
  return kind;
}

bool overlap(const CauseKind& a, const CauseKind& b) {
  if (a.joints.empty() || b.joints.empty()) return true;
  return std::ranges::any_of(a.joints,
                             [&](int joint) { return std::ranges::find(b.joints, joint) != b.joints.end(); });
}

}  // namespace

std::vector<CauseKind> causeKinds(const Groups& groups, const Mechanism& robot) {
  std::vector<CauseKind> kinds;
  for (const Cause& cause : possibleKinds(groups, robot))
    kinds.push_back(
        kindOf(robot, cause, middleStart(*cause.effect, cause.effect->scaleAt(robot, cause.place))));
  return kinds;
}

CauseKind configuredKind(const Groups& groups, const Mechanism& robot, const Cause& setting) {
  CauseKind kind = kindOf(robot, setting, setting.effect->strengthOf(setting.value));
  kind.price = priceOfMasks({setting}, recordingsOf(groups));
  return kind;
}

std::vector<CauseKind> windowKinds(const Groups& groups, const Mechanism& robot) {
  std::vector<CauseKind> kinds = causeKinds(groups, robot);
  std::erase_if(kinds, [](const CauseKind& kind) { return ofSensor(kind.cause); });
  return kinds;
}

bool hasFewKinds(const Groups& groups, const Mechanism& robot) {
  constexpr std::size_t few = 64;
  return windowKinds(groups, robot).size() <= few;
}

Cause causeAt(const Mechanism& robot, const CauseKind& kind, double x) {
  return withStrength(robot, kind.cause, x * kind.unit);
}

std::vector<std::vector<std::size_t>> colours(const std::vector<CauseKind>& kinds,
                                              const std::vector<std::size_t>& wanted) {
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t k : wanted) {
    const auto fits = std::ranges::find_if(groups, [&](const std::vector<std::size_t>& group) {
      return std::ranges::none_of(group, [&](std::size_t other) { return overlap(kinds[k], kinds[other]); });
    });
    if (fits == groups.end())
      groups.push_back({k});
    else
      fits->push_back(k);
  }
  return groups;
}

}  // namespace plumbline::gap
