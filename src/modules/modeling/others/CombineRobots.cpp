#include "modules/modeling/others/CombineRobots.h"

#include <algorithm>

namespace plumbline {
namespace {

constexpr double agreement = 3;  ///< [standard deviations]

OtherRobot combined(const OtherRobot& seen, const OtherRobot& heard) {
  const Vec2 apart = heard.position - seen.position;
  const Mat2 inverse = (seen.covariance + heard.covariance).inverse();
  if (apart.dot(inverse * apart) > agreement * agreement)
    return heard.lastSeen > seen.lastSeen ? heard : seen;
  OtherRobot both = heard.lastSeen > seen.lastSeen ? heard : seen;
  const Mat2 gain = seen.covariance * inverse;
  both.position = seen.position + gain * apart;
  both.velocity = seen.velocity;
  const Mat2 remaining = seen.covariance - gain * seen.covariance;
  both.covariance = 0.5 * (remaining + remaining.transpose());
  return both;
}

}  // namespace

std::vector<OtherRobot> combineRobots(const std::vector<OtherRobot>& seen,
                                      const std::vector<OtherRobot>& heard, double now, double ownSeconds) {
  std::vector<OtherRobot> all;
  all.reserve(seen.size() + heard.size());
  all = seen;
  for (const OtherRobot& robot : heard) {
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
