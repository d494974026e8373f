#include "simulation/referee/RobotBox.h"

#include <limits>

namespace plumbline::simulation {

namespace {

const Vec3 plateHalf(0.2, 0.28, 0.01);  ///< torso frame: forward, left, up

Vec3 reach(const Shape& shape, const Mat3& rotation) {
  switch (shape.kind) {
    case Shape::Kind::sphere:
      return Vec3::Constant(shape.size.x());
    case Shape::Kind::capsule:
      return Vec3::Constant(shape.size.x()) + rotation.col(2).cwiseAbs() * (shape.size.z() / 2);
    case Shape::Kind::box:
      break;
  }
  return rotation.cwiseAbs() * (shape.size / 2);
}

/// Pose of the middle of a link's shape.
Pose3 shapePose(const World& world, const Participant& player, std::size_t i) {
  const Link& link = player.model->links[i];
  return world.linkState(player.robot, static_cast<int>(i)).pose * translation(Vec3(-link.com)) *
         link.shape.T_link_shape;
}

}  // namespace

bool RobotBox::reachedBy(const Vec3& centre, double radius) const {
  return (centre.cwiseMax(low).cwiseMin(high) - centre).squaredNorm() <= radius * radius;
}

RobotBox robotBox(const World& world, const Participant& player) {
  const Pose3 torso = world.torso(player.robot).pose;
  const Vec3 plate = torso.linear().cwiseAbs() * plateHalf;
  RobotBox box{torso.translation() - plate, torso.translation() + plate};
  for (std::size_t i = 0; i < player.model->links.size(); ++i) {
    const Pose3 pose = shapePose(world, player, i);
    const Vec3 half = reach(player.model->links[i].shape, pose.linear());
    box.low = box.low.cwiseMin(pose.translation() - half);
    box.high = box.high.cwiseMax(pose.translation() + half);
  }
  return box;
}

Area robotArea(const World& world, const Participant& player) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Area area{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
  for (std::size_t i = 0; i < player.model->links.size(); ++i) {
    if (!player.model->links[i].collides) continue;
    const Vec2 middle = shapePose(world, player, i).translation().head<2>();
    area.low = area.low.cwiseMin(middle);
    area.high = area.high.cwiseMax(middle);
  }
  return area;
}

}  // namespace plumbline::simulation
