#include <array>

#include "gap/effects/Sizes.h"

namespace plumbline::gap {

namespace {

constexpr std::array<double, 2> wayOut{1, 1.5};  // to the far end

/// Where a link ends [m, its frame]: at the joint farthest from the one that moves it, or as far beyond its
/// centre of mass as that is from the joint.
Vec3 farEnd(const Mechanism& robot, int link) {
  Vec3 end = 2 * robot.links[static_cast<std::size_t>(link)].com;
  double farthest = 0;
  for (const Mechanism::Joint& joint : robot.joints)
    if (joint.parent == link && joint.origin.norm() > farthest) {
      end = joint.origin;
      farthest = end.norm();
    }
  return end;
}

/// A small body of that mass fixed to a link: mass, centre of mass and inertia change together.
void addBody(Mechanism::Link& link, double mass, const Vec3& place) {
  const double whole = link.mass + mass;
  const Vec3 apart = place - link.com;
  link.com += mass / whole * apart;
  link.inertia +=
      link.mass * mass / whole * (apart.squaredNorm() * Mat3::Identity() - apart * apart.transpose());
  link.mass = whole;
}

}  // namespace

/// Something small that a link carries.
const Effect payload{
    .id = "payload",
    .order = 460,
    .unit = "kg",
    .sites = {Site::link},
    .lower = 0,
    .upper = 1.5,
    .starts = {0.03, 0.15},
    .linear = true,
    .variants = {"at the link's far end", "beyond it by half the link"},
    .sentence = "{at} carries something at its far end.",
    .exposedBy = "static poses, slow motions",
    .scale = scaleOfMass,
    .apply =
        [](Plant& plant, const Place& place, double value, int variant) {
          const Vec3 at = wayOut[static_cast<std::size_t>(variant)] * farEnd(plant.mechanism, place.index);
          addBody(plant.mechanism.links[static_cast<std::size_t>(place.index)], value, at);
        },
    .inWalk = true,
    .canBeAt = [](const Mechanism& robot,
                  const Place& place) { return place.index > 0 && farEnd(robot, place.index).norm() > 0.01; },
    .drawing = {.where = DrawRange::Where::link, .low = 0.08, .high = 0.3},
};
MAKE_EFFECT(payload);

}  // namespace plumbline::gap
