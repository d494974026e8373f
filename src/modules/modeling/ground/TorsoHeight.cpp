#include "modules/modeling/ground/TorsoHeight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace plumbline {
namespace {

/// How far the shape reaches from its centre against the direction u, which is in the shape's axes.
double reach(const Shape& shape, const Vec3& u) {
  switch (shape.kind) {
    case Shape::Kind::box:
      return 0.5 * u.cwiseAbs().dot(shape.size);
    case Shape::Kind::capsule:
      return shape.size.x() + 0.5 * std::abs(u.z()) * shape.size.z();
    case Shape::Kind::sphere:
      break;
  }
  return shape.size.x();
}

}  // namespace

TorsoHeight::TorsoHeight(const RobotModel& model) {
  constexpr std::array feet{lAnkleRoll, rAnkleRoll, lToePitch, rToePitch};
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (link.collides) all_.push_back({i, link.shape});
    if (std::ranges::find(feet, link.joint) != feet.end()) feet_.push_back({i, link.shape});
  }
  if (feet_.empty()) feet_ = all_;
}

double TorsoHeight::aboveFeet(const Vec3& up, std::span<const Pose3> T_torso_link) const {
  return height(feet_, up, T_torso_link);
}

double TorsoHeight::aboveLowestPoint(const Vec3& up, std::span<const Pose3> T_torso_link) const {
  return height(all_, up, T_torso_link);
}

double TorsoHeight::height(const std::vector<Body>& bodies, const Vec3& up,
                           std::span<const Pose3> T_torso_link) {
  double highest = bodies.empty() ? 0 : -std::numeric_limits<double>::infinity();
  for (const Body& body : bodies) {
    const Pose3 T_torso_shape = T_torso_link[body.link] * body.shape.T_link_shape;
    const Vec3 u = T_torso_shape.linear().transpose() * up;
    highest = std::max(highest, reach(body.shape, u) - up.dot(T_torso_shape.translation()));
  }
  return highest;
}

}  // namespace plumbline
