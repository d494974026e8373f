#include "simulation/physics/ode/OdeTreeStep.h"

#include <algorithm>
#include <limits>

namespace plumbline::simulation::ode {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Two directions across a normal; any would do, because friction is the same in all.
std::pair<Vec3, Vec3> across(const Vec3& normal) {
  dVector3 n = {normal.x(), normal.y(), normal.z()}, p, q;
  dPlaneSpace(n, p, q);
  return {toVec3(p), toVec3(q)};
}

}  // namespace

void OdeTreeStep::step(const PhysicsConfig& config, const Assemblies& assemblies, OdeContacts& contacts) {
  islands_.find(assemblies, contacts.contacts());
  islands_.forEachAwake([&](const auto& island, const auto& contactIndices) {
    members_.clear();
    for (OdeAssembly* assembly : island) members_.push_back({assembly, {}, {}, {}});
    contactIndices_ = contactIndices;
    stepIsland(config, contacts);
  });
}

void OdeTreeStep::stepIsland(const PhysicsConfig& config, OdeContacts& contacts) {
  for (Member& member : members_) member.assembly->tree().begin(config);

  for (bool done = false; !done;) {
    rows_.clear();
    for (const std::size_t index : contactIndices_) appendContactRows(config, contacts, index);
    for (Member& member : members_) member.assembly->tree().appendRows(config, rows_);
    if (!rows_.empty()) solveRows();
    done = true;
    for (Member& member : members_) done = member.assembly->tree().finish(config) && done;
    if (!done)
      for (Member& member : members_) member.assembly->tree().solve(config);
  }

  const double h = config.stepSeconds;
  for (std::size_t k = 0; k < contactIndices_.size(); ++k) {
    const dContact& contact = contacts.found()[contactIndices_[k]];
    const Vec3 normal = toVec3(contact.geom.normal);
    const auto [t1, t2] = across(normal);
    const auto x = system_.solution().segment<3>(static_cast<Eigen::Index>(3 * k));
    contacts.setForce(contactIndices_[k], (x[0] * normal + x[1] * t1 + x[2] * t2) / h);
  }
  for (Member& member : members_) member.assembly->tree().integrate(config);
}

OdeTree* OdeTreeStep::treeOf(int handle) { return handle < 0 ? nullptr : &islands_.assembly(handle).tree(); }

void OdeTreeStep::appendContactRows(const PhysicsConfig& config, const OdeContacts& contacts,
                                    std::size_t index) {
  const double h = config.stepSeconds;
  const Contact& pair = contacts.contacts()[index];
  const dContact& contact = contacts.found()[index];
  const dSurfaceParameters& surface = contact.surface;
  const Vec3 normal = toVec3(contact.geom.normal), point = toVec3(contact.geom.pos);
  const auto [t1, t2] = across(normal);
  const int first = static_cast<int>(rows_.size());
  for (const Vec3& direction : {normal, t1, t2}) {
    OutsideRow row;
    row.sides[0].tree = treeOf(pair.assemblyA);
    row.sides[0].body = pair.bodyA;
    row.sides[1].tree = treeOf(pair.assemblyB);
    row.sides[1].body = pair.bodyB;
    for (int i = 0; i < 2; ++i)
      if (OutsideRow::Side& side = row.sides[i]; side.tree)
        side.direction = spatialImpulse(point - side.tree->origin(), i == 0 ? direction : Vec3(-direction));
    row.compliance = surface.slip1 / h;
    row.lower = -unbounded;
    row.upper = unbounded;
    if (surface.mode & dContactApprox1) {
      row.push = first;
      row.friction = surface.mu;
    }
    rows_.push_back(row);
  }
  OutsideRow& push = rows_[rows_.size() - 3];
  push.compliance = surface.soft_cfm / h;
  push.lower = 0;
  push.push = -1;
  push.wanted = surface.soft_erp / h * std::max(0.0, contact.geom.depth - config.surfaceLayer);
  if (surface.mode & dContactBounce) {
    double outgoing = 0;
    for (const OutsideRow::Side& side : push.sides) {
      if (!side.tree) continue;
      const TreeSystem::Body& body = side.tree->tree().body(side.body);
      const Vec3 arm = point - side.tree->origin() - body.position;
      const Vec3 velocity = body.linearVelocity + body.angularVelocity.cross(arm);
      outgoing += side.direction.head<3>().dot(velocity);
    }
    if (-outgoing > surface.bounce_vel) push.wanted = std::max(push.wanted, -surface.bounce * outgoing);
  }
}

/// Gives each tree the rows that reach it, with their places.
void OdeTreeStep::distributeRows() {
  for (Member& member : members_) {
    member.touched.clear();
    member.entries.clear();
    for (std::size_t r = 0; r < rows_.size(); ++r)
      for (const OutsideRow::Side& side : rows_[r].sides) {
        if (side.tree != &member.assembly->tree()) continue;
        const auto place = std::find(member.touched.begin(), member.touched.end(), side.body);
        const auto index = static_cast<std::size_t>(place - member.touched.begin());
        if (place == member.touched.end()) member.touched.push_back(side.body);
        member.entries.push_back({static_cast<Eigen::Index>(r), index, side.direction});
      }
    member.responses.clear();
    TreeSystem& tree = member.assembly->tree().tree();
    for (std::size_t i = 0; i < member.touched.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        member.responses.push_back(tree.response(member.touched[i], member.touched[j]));
  }
}

void OdeTreeStep::solveRows() {
  distributeRows();
  const auto count = static_cast<Eigen::Index>(rows_.size());
  system_.reset(count);
  frictionLimits_.clear();
  for (Eigen::Index r = 0; r < count; ++r) {
    const OutsideRow& row = rows_[static_cast<std::size_t>(r)];
    system_.a(r, r) = row.compliance;
    system_.b[r] = row.wanted;
    system_.lower[r] = row.lower;
    system_.upper[r] = row.upper;
    if (row.push >= 0) frictionLimits_.push_back({r, row.push, row.friction});
  }
  for (Member& member : members_) {
    TreeSystem& tree = member.assembly->tree().tree();
    answer_.resize(member.touched.size());
    for (const Member::Entry& from : member.entries) {
      const std::size_t j = from.touched;
      for (std::size_t i = 0; i < member.touched.size(); ++i)
        answer_[i] = i >= j ? Vec6(member.responses[i * (i + 1) / 2 + j] * from.direction)
                            : Vec6(member.responses[j * (j + 1) / 2 + i].transpose() * from.direction);
      for (const Member::Entry& to : member.entries)
        if (to.row >= from.row) system_.a(to.row, from.row) += to.direction.dot(answer_[to.touched]);
      system_.b[from.row] -= from.direction.dot(tree.velocity(member.touched[j]));
    }
  }
  const Eigen::VectorXd& x = solveWithFriction(system_, frictionLimits_);
  for (Member& member : members_)
    for (const Member::Entry& entry : member.entries)
      member.assembly->tree().tree().push(member.touched[entry.touched], x[entry.row] * entry.direction);
}

}  // namespace plumbline::simulation::ode
