#include "simulation/referee/LimbCollision.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::simulation {

namespace {

struct Box {
  Mat3 axes;
  Vec3 centre, half;
  double radius;
  int link;
};

bool separates(const Box& a, const Box& b, const Vec3& way, const Vec3& plane, double tolerance) {
  const double reach = (a.axes.transpose() * plane).cwiseAbs().dot(a.half) +
                       (b.axes.transpose() * plane).cwiseAbs().dot(b.half);
  return std::fabs(way.dot(plane)) + tolerance > reach;
}

/// The separating axis test with a tolerance; planes along two edges are not of unit length, as on the
/// server.
bool collide(const Box& a, const Box& b, double tolerance) {
  const Vec3 way = b.centre - a.centre;
  if (way.norm() > a.radius + b.radius) return false;
  for (int i = 0; i < 3; ++i)
    if (separates(a, b, way, a.axes.col(i), tolerance) || separates(a, b, way, b.axes.col(i), tolerance))
      return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (separates(a, b, way, a.axes.col(i).cross(b.axes.col(j)), tolerance)) return false;
  return true;
}

std::vector<Box> boxesOf(const World& world, RobotHandle robot, const RobotModel& model) {
  std::vector<Box> boxes;
  boxes.reserve(16);
  const auto& links = model.links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    if (!link.collides || link.shape.kind != Shape::Kind::box) continue;
    const Pose3 pose = world.linkState(robot, static_cast<int>(i)).pose * translation(Vec3(-link.com)) *
                       link.shape.T_link_shape;
    const Vec3 half = link.shape.size / 2;
    boxes.push_back({pose.linear(), pose.translation(), half, half.norm(), static_cast<int>(i)});
  }
  return boxes;
}

/// The next link towards the torso that collides, or -1: the one it hangs on.
int hangsOn(const RobotModel& model, int link) {
  do link = model.links[static_cast<std::size_t>(link)].parent;
  while (link >= 0 && !model.links[static_cast<std::size_t>(link)].collides);
  return link;
}

/// The link of its limb that hangs on the torso; 0: it is the torso.
int limbRoot(const RobotModel& model, int link) {
  while (link > 0 && model.links[static_cast<std::size_t>(link)].parent > 0)
    link = model.links[static_cast<std::size_t>(link)].parent;
  return link;
}

/// All joints of a link's limb.
Limb limbOf(const RobotModel& model, int link) {
  Limb limb;
  const int root = limbRoot(model, link);
  for (std::size_t i = 1; i < model.links.size(); ++i)
    if (model.links[i].joint != noJoint && limbRoot(model, static_cast<int>(i)) == root)
      limb.set(static_cast<std::size_t>(model.links[i].joint));
  return limb;
}

/// Whether two bodies that overlap count as no collision. Of an arm (a limb with a shoulder) every box is
/// compared with the torso. In other limbs a box is not compared with the one that it hangs on.
bool exempt(const RobotModel& model, int a, int b) {
  if (hangsOn(model, b) != a) return false;
  const int root = limbRoot(model, b);
  return std::ranges::none_of(std::array{lShoulderPitch, rShoulderPitch}, [&](JointId shoulder) {
    return model.has(shoulder) && limbRoot(model, model.linkOfJoint[shoulder]) == root;
  });
}

}  // namespace

std::vector<LimbCollision> limbCollisions(const World& world, RobotHandle robot, const RobotModel& model,
                                          double tolerance) {
  std::vector<LimbCollision> found;
  const std::vector<Box> boxes = boxesOf(world, robot, model);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (collide(boxes[i], boxes[j], tolerance) && !exempt(model, boxes[i].link, boxes[j].link))
        found.push_back({limbOf(model, boxes[i].link), limbOf(model, boxes[j].link)});
  return found;
}

}  // namespace plumbline::simulation
