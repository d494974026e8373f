#include "modules/modeling/others/BodyView.h"

#include <cmath>

namespace plumbline {
namespace {

constexpr double nearest = 0.15, farthest = 60;  ///< [m]
constexpr double highest = 1.2;  ///< part of a robot, and of a bad estimate of the own tilt [m]
constexpr double lowestAtDistance = 0.05,
                 low = 0.5;  ///< under the ground: share of the distance, at least [m]

Vec3 onGround(const PolarPoint& polar, const Pose3& T_ground_head) {
  const double flat = polar.distance * std::cos(polar.elevation);
  return T_ground_head * Vec3(flat * std::cos(polar.azimuth), flat * std::sin(polar.azimuth),
                              polar.distance * std::sin(polar.elevation));
}

bool plausible(const PolarPoint& polar, const Vec3& p) {
  return p.allFinite() && polar.distance > nearest && polar.distance < farthest && p.z() < highest &&
         p.z() > -low - lowestAtDistance * polar.distance;
}

}  // namespace

std::optional<BodyView> viewBody(const PolarPlayer& player, const Pose3& T_ground_head,
                                 const BodyViewParameters& parameters) {
  Vec2 sum = Vec2::Zero();
  std::optional<Vec3> head;
  int count = 0;
  for (const PolarBodyPart& part : player.parts) {
    const Vec3 p = onGround(part.position, T_ground_head);
    if (!plausible(part.position, p)) continue;
    sum += p.head<2>();
    ++count;
    if (part.name == "head") head = p;
  }
  if (count == 0) return std::nullopt;
  BodyView view;
  view.position = sum / count;
  if (head) {
    view.postureKnown = true;
    view.fallen = head->z() < parameters.fallenHeight;
    if (!view.fallen) view.position = head->head<2>();
  }
  const double distance = view.position.norm();
  const Vec2 along = distance > 1e-6 ? Vec2(view.position / distance) : Vec2(Vec2::UnitX());
  const Vec2 across(-along.y(), along.x());
  // A lying robot is long, and parts without a head may be all on one side.
  const double body = parameters.bodyNoise * (head && !view.fallen ? 1 : 3);
  const double a = std::hypot(body, parameters.distanceShare * distance);
  const double b = std::hypot(body, parameters.angleNoise * distance);
  view.covariance = a * a * along * along.transpose() + b * b * across * across.transpose();
  return view;
}

}  // namespace plumbline
