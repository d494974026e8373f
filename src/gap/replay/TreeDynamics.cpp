#include "gap/replay/TreeDynamics.h"

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
    node.prismatic = joint.type == Mechanism::Joint::Type::prismatic;
    node.turned = joint.rpy != Vec3::Zero();
    node.R0 = rotationOfRpy(joint.rpy);
    node.origin = joint.origin;
    node.axis = joint.axis;
    node.m = link.mass;
    node.com = link.com;
    node.I = link.inertia;
    nodeOfLink_[static_cast<std::size_t>(joint.child)] = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
  }
  const auto& torso = mechanism.links.at(0);
  baseMass_ = torso.mass;
  baseCom_ = torso.com;
  baseI_ = torso.inertia;
  M_.setZero(size(), size());
  biasForce_.setZero(size());
}

const TreeDynamics::Place& TreeDynamics::place(int link) const {
  if (link == 0) return base_;
  const int node = nodeOfLink_.at(static_cast<std::size_t>(link));
  if (node < 0) throw std::out_of_range("a link that does not move here");
  return nodes_[static_cast<std::size_t>(node)].place;
}

void TreeDynamics::setInertia(Inertia& inertia, const Place& place, double m, const Vec3& com,
                              const Mat3& I) {
  const Vec3 c = place.p + place.R * com;
  inertia.m = m;
  inertia.h = m * c;
  inertia.I.noalias() = place.R * I * place.R.transpose();
  const Vec3 hc = inertia.h.cwiseProduct(c);
  const double xy = inertia.h.x() * c.y(), xz = inertia.h.x() * c.z(), yz = inertia.h.y() * c.z();
  inertia.I(0, 0) += hc.y() + hc.z();
  inertia.I(1, 1) += hc.x() + hc.z();
  inertia.I(2, 2) += hc.x() + hc.y();
  inertia.I(0, 1) -= xy;
  inertia.I(1, 0) -= xy;
  inertia.I(0, 2) -= xz;
  inertia.I(2, 0) -= xz;
  inertia.I(1, 2) -= yz;
  inertia.I(2, 1) -= yz;
}

void TreeDynamics::update(const Mat3& R_world_base, const double* q, const double* v) {
  base_.R = R_world_base;
  if (offset_) {
    base_.u = Eigen::Map<const Vec3>(v);
    base_.w = Eigen::Map<const Vec3>(v + 3);
    // The point of the base that is at O keeps its world velocity's derivative: classical acceleration zero.
    base_.au = -gravity_ - base_.w.cross(base_.u);
  } else {
    base_.au = -gravity_;
  }
  base_.aw.setZero();

  const int n = static_cast<int>(nodes_.size());
  for (int i = 0; i < n; ++i) {
    Node& node = nodes_[static_cast<std::size_t>(i)];
    const Place& parent = node.parent < 0 ? base_ : nodes_[static_cast<std::size_t>(node.parent)].place;
    Place& here = node.place;
    const Mat3 R = node.turned ? Mat3(parent.R * node.R0) : parent.R;
    const Vec3 axis = R * node.axis;
    here.p = parent.p + parent.R * node.origin;
    const double rate = v[offset_ + i];
    if (node.prismatic) {
      here.R = R;
      here.p += axis * q[i];
      node.sw.setZero();
      node.su = axis;
    } else {
      here.R.noalias() = R * Eigen::AngleAxisd(q[i], node.axis).toRotationMatrix();
      node.sw = axis;
      node.su = here.p.cross(axis);
    }
    here.w = parent.w + node.sw * rate;
    here.u = parent.u + node.su * rate;
    here.aw = parent.aw + here.w.cross(node.sw) * rate;
    here.au = parent.au + (here.w.cross(node.su) + here.u.cross(node.sw)) * rate;
    setInertia(node.own, here, node.m, node.com, node.I);
    node.composite = node.own;
    const Inertia& o = node.own;
    const Vec3 pu = o.m * here.u - o.h.cross(here.w);
    const Vec3 pn = o.I * here.w + o.h.cross(here.u);
    node.fu = o.m * here.au - o.h.cross(here.aw) + here.w.cross(pu);
    node.fn = o.I * here.aw + o.h.cross(here.au) + here.w.cross(pn) + here.u.cross(pu);
  }

  Vec3 baseForce = Vec3::Zero(), baseMoment = Vec3::Zero();
  if (offset_) {
    setInertia(baseOwn_, base_, baseMass_, baseCom_, baseI_);
    baseComposite_ = baseOwn_;
    const Inertia& o = baseOwn_;
    const Vec3 pu = o.m * base_.u - o.h.cross(base_.w);
    const Vec3 pn = o.I * base_.w + o.h.cross(base_.u);
    baseForce = o.m * base_.au + base_.w.cross(pu);
    baseMoment = o.h.cross(base_.au) + base_.w.cross(pn) + base_.u.cross(pu);
  }
  for (int i = n - 1; i >= 0; --i) {
    Node& node = nodes_[static_cast<std::size_t>(i)];
    biasForce_[offset_ + i] = node.sw.dot(node.fn) + node.su.dot(node.fu);
    const Inertia& c = node.composite;
    const Vec3 fu = c.m * node.su - c.h.cross(node.sw);
    const Vec3 fn = c.I * node.sw + c.h.cross(node.su);
    M_(offset_ + i, offset_ + i) = node.sw.dot(fn) + node.su.dot(fu);
    for (int j = node.parent; j >= 0; j = nodes_[static_cast<std::size_t>(j)].parent) {
      const Node& other = nodes_[static_cast<std::size_t>(j)];
      M_(offset_ + i, offset_ + j) = M_(offset_ + j, offset_ + i) = other.sw.dot(fn) + other.su.dot(fu);
    }
    if (offset_) {
      M_.block<3, 1>(0, offset_ + i) = fu;
      M_.block<3, 1>(3, offset_ + i) = fn;
      M_.block<1, 3>(offset_ + i, 0) = fu.transpose();
      M_.block<1, 3>(offset_ + i, 3) = fn.transpose();
    }
    Inertia* up = node.parent < 0 ? (offset_ ? &baseComposite_ : nullptr)
                                  : &nodes_[static_cast<std::size_t>(node.parent)].composite;
    if (up) {
      up->m += c.m;
      up->h += c.h;
      up->I += c.I;
    }
    if (node.parent >= 0) {
      nodes_[static_cast<std::size_t>(node.parent)].fu += node.fu;
      nodes_[static_cast<std::size_t>(node.parent)].fn += node.fn;
    } else {
      baseForce += node.fu;
      baseMoment += node.fn;
    }
  }
  if (offset_) {
    const Inertia& c = baseComposite_;
    const auto cross = [](const Vec3& h) {
      Mat3 m;
      m << 0, -h.z(), h.y(), h.z(), 0, -h.x(), -h.y(), h.x(), 0;
      return m;
    };
    M_.block<3, 3>(0, 0) = Mat3::Identity() * c.m;
    M_.block<3, 3>(0, 3) = -cross(c.h);
    M_.block<3, 3>(3, 0) = cross(c.h);
    M_.block<3, 3>(3, 3) = c.I;
    biasForce_.head<3>() = baseForce;
    biasForce_.segment<3>(3) = baseMoment;
  }
}

Vec3 TreeDynamics::velocityAt(int link, const Vec3& point) const {
  const Place& here = place(link);
  return here.u + here.w.cross(point);
}

Vec3 TreeDynamics::specificForceAt(int link, const Vec3& point, const double* dv) const {
  const Place& here = place(link);
  Vec3 aw = here.aw, au = here.au;
  if (offset_) {
    au += Eigen::Map<const Vec3>(dv);
    aw += Eigen::Map<const Vec3>(dv + 3);
  }
  for (int i = link == 0 ? -1 : nodeOfLink_[static_cast<std::size_t>(link)]; i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    aw += nodes_[static_cast<std::size_t>(i)].sw * dv[offset_ + i];
    au += nodes_[static_cast<std::size_t>(i)].su * dv[offset_ + i];
  }
  // Spatial to classical acceleration of the point.
  return au + aw.cross(point) + here.w.cross(here.u + here.w.cross(point));
}

void TreeDynamics::addForce(int link, const Vec3& point, const Vec3& force, Eigen::VectorXd& tau) const {
  const Vec3 moment = point.cross(force);
  for (int i = link == 0 ? -1 : nodeOfLink_.at(static_cast<std::size_t>(link)); i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    tau[offset_ + i] += node.sw.dot(moment) + node.su.dot(force);
  }
  if (offset_) {
    tau.head<3>() += force;
    tau.segment<3>(3) += moment;
  }
}

void TreeDynamics::jacobian(int link, const Vec3& point, Eigen::Ref<Eigen::MatrixXd> J) const {
  J.setZero();
  for (int i = link == 0 ? -1 : nodeOfLink_.at(static_cast<std::size_t>(link)); i >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    J.col(offset_ + i) = node.su + node.sw.cross(point);
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
