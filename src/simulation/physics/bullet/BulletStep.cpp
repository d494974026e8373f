#include "simulation/physics/bullet/BulletStep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::simulation::bullet {

void BulletStep::step(const PhysicsConfig& config, const Assemblies& assemblies, BulletContacts& contacts) {
  islands_.find(assemblies, contacts.contacts());
  islands_.forEachAwake([&](const auto& members, const auto& contactIndices) {
    members_ = members;
    contactIndices_ = contactIndices;
    stepIsland(config, contacts);
  });
}

void BulletStep::stepIsland(const PhysicsConfig& config, BulletContacts& contacts) {
  for (BulletAssembly* member : members_) member->begin(config);
  directions_.clear();
  outgoing_.clear();
  for (const std::size_t i : contactIndices_) addContactRows(contacts, i);
  hingeRows_.clear();
  for (BulletAssembly* member : members_)
    for (const BulletAssembly::HingeRow& row : member->addHingeRows(config))
      hingeRows_.push_back({member, row});
  while (!solve(config, contacts)) {
  }
  for (BulletAssembly* member : members_) member->applyImpulses(system_.solution());
  for (std::size_t k = 0; k < contactIndices_.size(); ++k) {
    Vec3 force = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      force += system_.solution()[static_cast<Eigen::Index>(3 * k + i)] / config.stepSeconds *
               directions_[3 * k + i];
    contacts.setForce(contactIndices_[k], force);
  }
  for (BulletAssembly* member : members_) member->finish(config);
}

void BulletStep::addContactRows(const BulletContacts& contacts, std::size_t index) {
  const Contact& pair = contacts.contacts()[index];
  btVector3 t1, t2;
  btPlaneSpace1(fromVec3(contacts.geometry()[index].normal), t1, t2);
  double speed = 0;
  for (const Vec3& direction : {contacts.geometry()[index].normal, toVec3(t1), toVec3(t2)}) {
    const auto global = static_cast<Eigen::Index>(directions_.size());
    const auto add = [&](int handle, int body, const Vec3& along) {
      if (handle < 0) return;
      BulletAssembly& assembly = islands_.assembly(handle);
      const int row = assembly.addPointRow(body, pair.point, along);
      assembly.rows().place(row, global);
      if (global % 3 == 0) speed += assembly.rows().velocityBefore(row);
    };
    add(pair.assemblyA, pair.bodyA, direction);
    add(pair.assemblyB, pair.bodyB, -direction);
    directions_.push_back(direction);
  }
  outgoing_.push_back(speed);
}

void BulletStep::fillSystem(const PhysicsConfig& config, const BulletContacts& contacts) {
  const double h = config.stepSeconds;
  const auto bounded = std::count_if(hingeRows_.begin(), hingeRows_.end(),
                                     [](const HingeRow& hinge) { return hinge.row.stop || hinge.saturated; });
  system_.reset(static_cast<Eigen::Index>(directions_.size()) + bounded);
  frictionLimits_.clear();
  for (std::size_t k = 0; k < contactIndices_.size(); ++k) {
    const ContactGeometry& contact = contacts.geometry()[contactIndices_[k]];
    const ContactSurface& surface = contact.surface;
    const auto normal = static_cast<Eigen::Index>(3 * k);
    system_.a(normal, normal) = surface.softCfm / h;
    system_.b[normal] = surface.softErp / h * std::max(0.0, contact.depth - config.surfaceLayer);
    if (surface.bounce > 0 && -outgoing_[k] > surface.bounceVelocity)
      system_.b[normal] = std::max(system_.b[normal], -surface.bounce * outgoing_[k]);
    system_.lower[normal] = 0;
    for (const Eigen::Index friction : {normal + 1, normal + 2}) {
      system_.a(friction, friction) = surface.slip / h;
      if (std::isfinite(surface.friction)) frictionLimits_.push_back({friction, normal, surface.friction});
    }
  }
  auto place = static_cast<Eigen::Index>(directions_.size());
  for (BulletAssembly* member : members_) member->rows().releaseAll();
  for (const HingeRow& hinge : hingeRows_) {
    const BulletAssembly::HingeRow& row = hinge.row;
    if (!row.stop && !hinge.saturated) {
      hinge.assembly->rows().hold(row.local, row.wanted, row.compliance);
      continue;
    }
    hinge.assembly->rows().place(row.local, place);
    system_.a(place, place) = row.compliance;
    system_.b[place] = row.wanted;
    const double most = hinge.assembly->maxTorque(row.hinge) * h;
    system_.lower[place] = hinge.saturated ? -most : row.lower;
    system_.upper[place] = hinge.saturated ? most : row.upper;
    ++place;
  }
  for (BulletAssembly* member : members_) member->rows().addTo(system_);
}

/// Solves the island with each motor at its limit or not, as found so far. False if more motors would need
/// more than they have; then it must be solved again.
bool BulletStep::solve(const PhysicsConfig& config, const BulletContacts& contacts) {
  fillSystem(config, contacts);
  solveWithFriction(system_, frictionLimits_);
  bool done = true;
  for (BulletAssembly* member : members_) {
    const Eigen::VectorXd& impulses = member->rows().heldImpulses(system_.solution());
    Eigen::Index i = 0;
    for (HingeRow& hinge : hingeRows_) {
      if (hinge.assembly != member || hinge.row.stop || hinge.saturated) continue;
      if (std::abs(impulses[i++]) > member->maxTorque(hinge.row.hinge) * config.stepSeconds) {
        hinge.newlySaturated = true;
        done = false;
      }
    }
  }
  for (HingeRow& hinge : hingeRows_) hinge.saturated = hinge.saturated || hinge.newlySaturated;
  return done;
}

}  // namespace plumbline::simulation::bullet
