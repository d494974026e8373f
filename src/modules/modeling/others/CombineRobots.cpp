#include "modules/modeling/others/CombineRobots.h"

#include <algorithm>

namespace plumbline {
namespace {

constexpr double agreement = 3;  ///< [standard deviations]

OtherRobot combined(const OtherRobot& seen, const OtherRobot& told) {
  const Vec2 apart = told.position - seen.position;
  const Mat2 inverse = (seen.covariance + told.covariance).inverse();
  if (apart.dot(inverse * apart) > agreement * agreement) return told.lastSeen > seen.lastSeen ? told : seen;
  OtherRobot both = told.lastSeen > seen.lastSeen ? told : seen;
  const Mat2 gain = seen.covariance * inverse;
  both.position = seen.position + gain * apart;
  both.velocity = seen.velocity;
  const Mat2 remaining = seen.covariance - gain * seen.covariance;
  both.covariance = 0.5 * (remaining + remaining.transpose());
  return both;
}

}  // namespace

std::vector<OtherRobot> combineRobots(const std::vector<OtherRobot>& seen,
                                      const std::vector<OtherRobot>& told, double now, double ownSeconds) {
  std::vector<OtherRobot> all = seen;
  for (const OtherRobot& robot : told) {
    const auto own = std::ranges::find_if(
        all, [&](const OtherRobot& r) { return r.mate == robot.mate && r.number == robot.number; });
    if (own == all.end())
      all.push_back(robot);
    else if (now - own->lastSeen > ownSeconds)
      *own = combined(*own, robot);
  }
  return all;
}

}  // namespace plumbline
