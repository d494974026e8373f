#include "modules/modeling/selflocator/FieldView.h"

#include <cmath>

#include "math/Angle.h"

namespace plumbline {

GroundPoint projectToGround(double distance, double azimuth, double elevation, const Pose3& T_ground_head,
                            const VisionModel& noise) {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  const Mat3 R = T_ground_head.linear();
  const Vec3 away = R * Vec3(ce * ca, ce * sa, se);
  const Vec3 aside = R * Vec3(-sa, ca, 0);
  const Vec3 above = away.cross(aside);
  const Vec3 point = T_ground_head.translation() + distance * away;

  GroundPoint result;
  result.position = point.head<2>();
  result.height = point.z();
  const auto square = [](double v) { return v * v; };
  const double along = square(noise.distanceShare * distance) + square(noise.distance);
  const double across = square(noise.azimuth * distance * ce);
  const double up = square(noise.elevation * distance);
  // A wrong tilt shifts a point by its height over or under the head.
  const double common =
      square(noise.offset) + square(noise.tilt * (point.z() - T_ground_head.translation().z()));
  const Vec2 u = away.head<2>(), v = aside.head<2>(), w = above.head<2>();
  result.covariance = along * u * u.transpose() + across * v * v.transpose() + up * w * w.transpose() +
                      common * Mat2::Identity();
  result.information = result.covariance.inverse();
  return result;
}

bool atImageBorder(double azimuth, double elevation, double tangent) {
  const double ce = std::cos(elevation);
  const double x = ce * std::cos(azimuth);
  return std::abs(ce * std::sin(azimuth)) > tangent * x || std::abs(std::sin(elevation)) > tangent * x;
}

}  // namespace plumbline
