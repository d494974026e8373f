#include "simulation/physics/bullet/BulletStep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::simulation::bullet {

void BulletStep::step(const PhysicsConfig& config, const Assemblies& assemblies, BulletContacts& contacts) {
  islands.find(assemblies, contacts.contacts());
  islands.forEachAwake([&](const auto& members_, const auto& contactIndices_) {
    members = members_;
    contactIndices = contactIndices_;
    stepIsland(config, contacts);
  });
}

void BulletStep::stepIsland(const PhysicsConfig& config, BulletContacts& contacts) {
  for (BulletAssembly* member : members) member->begin(config);
  directions.clear();
  outgoing.clear();
  for (const std::size_t i : contactIndices) addContactRows(contacts, i);
  hingeRows.clear();
  for (BulletAssembly* member : members)
    for (const BulletAssembly::HingeRow& row : member->addHingeRows(config))
      hingeRows.push_back({member, row});
  while (!solve(config, contacts)) {
  }
  for (BulletAssembly* member : members) member->applyImpulses(system.solution());
  for (std::size_t k = 0; k < contactIndices.size(); ++k) {
    Vec3 force = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      force += system.solution()[static_cast<Eigen::Index>(3 * k + i)] / config.stepSeconds *
               directions[3 * k + i];
    contacts.setForce(contactIndices[k], force);
  }
  for (BulletAssembly* member : members) member->finish(config);
}

void BulletStep::addContactRows(const BulletContacts& contacts, std::size_t index) {
  const Contact& pair = contacts.contacts()[index];
  btVector3 t1, t2;
  btPlaneSpace1(fromVec3(contacts.geometry()[index].normal), t1, t2);
  double speed = 0;
  for (const Vec3& direction : {contacts.geometry()[index].normal, toVec3(t1), toVec3(t2)}) {
    const auto global = static_cast<Eigen::Index>(directions.size());
    const auto add = [&](int handle, int body, const Vec3& along) {
      if (handle < 0) return;
      BulletAssembly& assembly = islands.assembly(handle);
      const int row = assembly.addPointRow(body, pair.point, along);
      assembly.rows().place(row, global);
      if (global % 3 == 0) speed += assembly.rows().velocityBefore(row);
    };
    add(pair.assemblyA, pair.bodyA, direction);
    add(pair.assemblyB, pair.bodyB, -direction);
    directions.push_back(direction);
  }
  outgoing.push_back(speed);
}

void BulletStep::fillSystem(const PhysicsConfig& config, const BulletContacts& contacts) {
  const double h = config.stepSeconds;
  const auto bounded = std::count_if(hingeRows.begin(), hingeRows.end(),
                                     [](const HingeRow& hinge) { return hinge.row.stop || hinge.saturated; });
  system.reset(static_cast<Eigen::Index>(directions.size()) + bounded);
  frictionLimits.clear();
  for (std::size_t k = 0; k < contactIndices.size(); ++k) {
    const ContactGeometry& contact = contacts.geometry()[contactIndices[k]];
    const ContactSurface& surface = contact.surface;
    const auto normal = static_cast<Eigen::Index>(3 * k);
    system.a(normal, normal) = surface.softCfm / h;
    system.b[normal] = surface.softErp / h * std::max(0.0, contact.depth - config.surfaceLayer);
    if (surface.bounce > 0 && -outgoing[k] > surface.bounceVelocity)
      system.b[normal] = std::max(system.b[normal], -surface.bounce * outgoing[k]);
    system.lower[normal] = 0;
    for (const Eigen::Index friction : {normal + 1, normal + 2}) {
      system.a(friction, friction) = surface.slip / h;
      if (std::isfinite(surface.friction)) frictionLimits.push_back({friction, normal, surface.friction});
    }
  }
  auto place = static_cast<Eigen::Index>(directions.size());
  for (BulletAssembly* member : members) member->rows().releaseAll();
  for (const HingeRow& hinge : hingeRows) {
    const BulletAssembly::HingeRow& row = hinge.row;
    if (!row.stop && !hinge.saturated) {
      hinge.assembly->rows().hold(row.local, row.wanted, row.compliance);
      continue;
    }
    hinge.assembly->rows().place(row.local, place);
    system.a(place, place) = row.compliance;
    system.b[place] = row.wanted;
    const double most = hinge.assembly->maxTorque(row.hinge) * h;
    system.lower[place] = hinge.saturated ? -most : row.lower;
    system.upper[place] = hinge.saturated ? most : row.upper;
    ++place;
  }
  for (BulletAssembly* member : members) member->rows().addTo(system);
}

/// Solves the island with motors as they are known to be: at their limit or not. False, if more of them would
/// need more than they have; then all is to be done again.
bool BulletStep::solve(const PhysicsConfig& config, const BulletContacts& contacts) {
  fillSystem(config, contacts);
  solveWithFriction(system, frictionLimits);
  bool done = true;
  for (BulletAssembly* member : members) {
    const Eigen::VectorXd& impulses = member->rows().heldImpulses(system.solution());
    Eigen::Index i = 0;
    for (HingeRow& hinge : hingeRows) {
      if (hinge.assembly != member || hinge.row.stop || hinge.saturated) continue;
      if (std::abs(impulses[i++]) > member->maxTorque(hinge.row.hinge) * config.stepSeconds) {
        hinge.newlySaturated = true;
        done = false;
      }
    }
  }
  for (HingeRow& hinge : hingeRows) hinge.saturated = hinge.saturated || hinge.newlySaturated;
  return done;
}

}  // namespace plumbline::simulation::bullet
