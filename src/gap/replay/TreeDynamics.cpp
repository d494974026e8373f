#include "gap/replay/TreeDynamics.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace plumbline::gap {

TreeDynamics::TreeDynamics(const Mechanism& mechanism, std::vector<int> joints, bool freeBase)
    : chosen_(std::move(joints)), offset_(freeBase ? 6 : 0), gravity_(mechanism.gravity) {
  nodeOfLink_.assign(mechanism.links.size(), -1);
  for (const int index : chosen_) {
    const auto& joint = mechanism.joints.at(static_cast<std::size_t>(index));
    const auto& link = mechanism.links.at(static_cast<std::size_t>(joint.child));
    Node node;
    node.link = joint.child;
    node.parent = nodeOfLink_[static_cast<std::size_t>(joint.parent)];
    if (node.parent < 0 && joint.parent != 0) {
      throw std::invalid_argument("joint " + joint.name + " without the joints that carry it");
    }
    constexpr std::array about{Node::Motion::aboutX, Node::Motion::aboutY, Node::Motion::aboutZ};
    node.motion = Node::Motion::aboutAxis;
    for (std::size_t i = 0; i < about.size(); ++i) {
      const double along = joint.axis[static_cast<Eigen::Index>(i)];
      if (std::abs(along) == 1 && joint.axis.cwiseAbs().sum() == 1)
        node.motion = about[i], node.sense = along;
    }
    if (joint.type == Mechanism::Joint::Type::prismatic) node.motion = Node::Motion::alongAxis;
    node.turned = joint.rpy != Vec3::Zero();
    node.R0 = tripleOf(rotationOfRpy(joint.rpy));
    node.origin = tripleOf(joint.origin);
    node.axis = tripleOf(joint.axis);
    node.body = {link.mass, tripleOf(link.com), tripleOf(link.inertia)};
    nodeOfLink_[static_cast<std::size_t>(joint.child)] = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
  }
  const auto& torso = mechanism.links.at(0);
  baseBody_ = {torso.mass, tripleOf(torso.com), tripleOf(torso.inertia)};
  M_.setZero(size(), size());
  biasForce_.setZero(size());
}

const TreeDynamics::Place& TreeDynamics::place(int link) const {
  if (link == 0) return base_;
  const int node = nodeOfLink_.at(static_cast<std::size_t>(link));
  if (node < 0) throw std::out_of_range("a link that does not move here");
  return nodes_[static_cast<std::size_t>(node)].place;
}

/// Where the joint's position and rate [rad, m; per s] put its link.
void TreeDynamics::move(Node& node, const Place& parent, double q, double rate) {
  Place& here = node.place;
  const TripleMatrix R = node.turned ? parent.R * node.R0 : parent.R;
  Triple p = parent.p + parent.R * node.origin, axis;
  if (node.motion == Node::Motion::alongAxis) {
    axis = R * node.axis;
    p = p + q * axis;
    here.R = R;
    node.sw = {};
    node.su = axis;
  } else {
    // As Eigen has it: the cosine on the axis is (1 - c) + c, which is not always 1.
    const double c = node.cosine, s = node.sense * node.sine, kept = (1 - c) + c;
    switch (node.motion) {
      case Node::Motion::aboutX:
        axis = node.sense * R.x;
        here.R = {kept * R.x, c * R.y + s * R.z, c * R.z - s * R.y};
        break;
      case Node::Motion::aboutY:
        axis = node.sense * R.y;
        here.R = {c * R.x - s * R.z, kept * R.y, s * R.x + c * R.z};
        break;
      case Node::Motion::aboutZ:
        axis = node.sense * R.z;
        here.R = {c * R.x + s * R.y, c * R.y - s * R.x, kept * R.z};
        break;
      default:
        axis = R * node.axis;
        here.R = R * tripleOf(Eigen::AngleAxisd(q, vectorOf(node.axis)).toRotationMatrix());
    }
    node.sw = axis;
    node.su = cross(p, axis);
  }
  const Triple sw = node.sw, su = node.su, w = parent.w + rate * sw, u = parent.u + rate * su;
  here.p = p;
  here.w = w;
  here.u = u;
  here.aw = parent.aw + rate * cross(w, sw);
  here.au = parent.au + rate * (cross(w, su) + cross(u, sw));
}

/// A body's inertia, and the force that its motion needs.
void TreeDynamics::take(const Body& body, const Place& here, Inertia& inertia, Force& force) {
  const double m = body.m;
  const Triple c = here.p + here.R * body.com, h = m * c;
  TripleMatrix I = here.R * body.I * transposed(here.R);
  const double xx = h.x * c.x, yy = h.y * c.y, zz = h.z * c.z;
  const double xy = h.x * c.y, xz = h.x * c.z, yz = h.y * c.z;
  I = {{I.x.x + (yy + zz), I.x.y - xy, I.x.z - xz},
       {I.y.x - xy, I.y.y + (xx + zz), I.y.z - yz},
       {I.z.x - xz, I.z.y - yz, I.z.z + (xx + yy)}};
  const Triple w = here.w, u = here.u;
  const Triple pu = m * u - cross(h, w), pn = I * w + cross(h, u);  // momentum
  force.f = m * here.au - cross(h, here.aw) + cross(w, pu);
  force.n = I * here.aw + cross(h, here.au) + cross(w, pn) + cross(u, pu);
  inertia = {m, h, I};
}

void TreeDynamics::update(const Mat3& R_world_base, const double* q, const double* v) {
  base_.R = tripleOf(R_world_base);
  base_.au = -1.0 * tripleOf(gravity_);
  if (offset_) {
    base_.u = {v[0], v[1], v[2]};
    base_.w = {v[3], v[4], v[5]};
    // The point of the base that is at O keeps its world velocity's derivative: classical acceleration zero.
    base_.au = base_.au - cross(base_.w, base_.u);
    take(baseBody_, base_, baseComposite_, baseForce_);
  }
  const int n = static_cast<int>(nodes_.size()), size = offset_ + n;
  Node* const nodes = nodes_.data();
  // In loops of their own: the processor works on several of these at once.
  for (int i = 0; i < n; ++i) {
    if (nodes[i].motion == Node::Motion::alongAxis) continue;
    const double angle = q[i];
    nodes[i].cosine = std::cos(angle);
    nodes[i].sine = std::sin(angle);
  }
  for (int i = 0; i < n; ++i)
    move(nodes[i], nodes[i].parent < 0 ? base_ : nodes[nodes[i].parent].place, q[i], v[offset_ + i]);
  for (int i = n - 1; i >= 0; --i) take(nodes[i].body, nodes[i].place, nodes[i].composite, nodes[i].force);
  double *const M = M_.data(), *const bias = biasForce_.data();
  const auto add = [](const Inertia& c, const Force& f, Inertia& inertia, Force& force) {
    inertia = {inertia.m + c.m, inertia.h + c.h, inertia.I + c.I};
    force = {force.f + f.f, force.n + f.n};
  };
  for (int i = n - 1; i >= 0; --i) {
    const Node& node = nodes[i];
    const Inertia& c = node.composite;
    const Triple fu = c.m * node.su - cross(c.h, node.sw), fn = c.I * node.sw + cross(c.h, node.su);
    const int at = offset_ + i;
    bias[at] = dot(node.sw, node.force.n) + dot(node.su, node.force.f);
    M[at + size * at] = dot(node.sw, fn) + dot(node.su, fu);
    for (int j = node.parent; j >= 0; j = nodes[j].parent)
      M[at + size * (offset_ + j)] = M[offset_ + j + size * at] = dot(nodes[j].sw, fn) + dot(nodes[j].su, fu);
    if (offset_) {
      const double column[6] = {fu.x, fu.y, fu.z, fn.x, fn.y, fn.z};
      for (int j = 0; j < 6; ++j) M[at + size * j] = M[j + size * at] = column[j];
    }
    if (node.parent >= 0) {
      add(c, node.force, nodes[node.parent].composite, nodes[node.parent].force);
    } else if (offset_) {
      add(c, node.force, baseComposite_, baseForce_);
    }
  }
  if (!offset_) return;
  const Vec3 h = vectorOf(baseComposite_.h);
  Mat3 cross;
  cross << 0, -h.z(), h.y(), h.z(), 0, -h.x(), -h.y(), h.x(), 0;
  M_.block<3, 3>(0, 0) = Mat3::Identity() * baseComposite_.m;
  M_.block<3, 3>(0, 3) = -cross;
  M_.block<3, 3>(3, 0) = cross;
  M_.block<3, 3>(3, 3) = matrixOf(baseComposite_.I);
  biasForce_.head<3>() = vectorOf(baseForce_.f);
  biasForce_.segment<3>(3) = vectorOf(baseForce_.n);
}

Vec3 TreeDynamics::velocityAt(int link, const Vec3& point) const {
  const Place& here = place(link);
  return vectorOf(here.u + cross(here.w, tripleOf(point)));
}

Vec3 TreeDynamics::specificForceAt(int link, const Vec3& point, const double* dv) const {
  const Place& here = place(link);
  Triple aw = here.aw, au = here.au;
  if (offset_) {
    au = au + Triple{dv[0], dv[1], dv[2]};
    aw = aw + Triple{dv[3], dv[4], dv[5]};
  }
  for (int i = link == 0 ? -1 : nodeOfLink_[static_cast<std::size_t>(link)]; i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    aw = aw + dv[offset_ + i] * nodes_[static_cast<std::size_t>(i)].sw;
    au = au + dv[offset_ + i] * nodes_[static_cast<std::size_t>(i)].su;
  }
  // Spatial to classical acceleration of the point.
  const Triple at = tripleOf(point);
  return vectorOf(au + cross(aw, at) + cross(here.w, here.u + cross(here.w, at)));
}

void TreeDynamics::addForce(int link, const Vec3& point, const Vec3& force, Eigen::VectorXd& tau) const {
  const Triple f = tripleOf(force), moment = cross(tripleOf(point), f);
  for (int i = link == 0 ? -1 : nodeOfLink_.at(static_cast<std::size_t>(link)); i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    tau[offset_ + i] += dot(node.sw, moment) + dot(node.su, f);
  }
  if (offset_) {
    tau.head<3>() += force;
    tau.segment<3>(3) += vectorOf(moment);
  }
}

void TreeDynamics::jacobian(int link, const Vec3& point, Eigen::Ref<Eigen::MatrixXd> J) const {
  J.setZero();
  for (int i = link == 0 ? -1 : nodeOfLink_.at(static_cast<std::size_t>(link)); i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    J.col(offset_ + i) = vectorOf(node.su + cross(node.sw, tripleOf(point)));
  }
  if (offset_) {
    J.block<3, 3>(0, 0).setIdentity();
    J(0, 4) = point.z();
    J(0, 5) = -point.y();
    J(1, 3) = -point.z();
    J(1, 5) = point.x();
    J(2, 3) = point.y();
    J(2, 4) = -point.x();
  }
}

}  // namespace plumbline::gap
