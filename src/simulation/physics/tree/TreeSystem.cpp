#include "simulation/physics/tree/TreeSystem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::simulation {

namespace {

/// Z^T m Z for Z = [1, -cross(gap); 0, 1], which takes a velocity of the parent to the child's anchor.
Mat6 carryToParent(const Mat6& m, const Vec3& gap) {
  const Mat3 d = cross(gap);
  const Mat3 a = m.topLeftCorner<3, 3>(), b = m.topRightCorner<3, 3>(), e = m.bottomRightCorner<3, 3>();
  const Mat3 ad = a * d;
  Mat6 result;
  result.topLeftCorner<3, 3>() = a;
  result.topRightCorner<3, 3>() = b - ad;
  result.bottomLeftCorner<3, 3>() = (b - ad).transpose();
  result.bottomRightCorner<3, 3>() = e + d * b - b.transpose() * d - d * ad;
  return result;
}

/// Z^T x.
Vec6 impulseToParent(const Vec6& x, const Vec3& gap) {
  Vec6 result = x;
  result.tail<3>() += gap.cross(Vec3(x.head<3>()));
  return result;
}

/// Z v.
Vec6 velocityOfParent(const Vec6& v, const Vec3& gap) {
  Vec6 result = v;
  result.head<3>() += Vec3(v.tail<3>()).cross(gap);
  return result;
}

/// C at the child's anchor, about O.
Mat6 complianceAboutOrigin(const TreeSystem::Joint& joint) {
  const Mat3 y = cross(joint.childAnchor);
  const Mat3 angular = joint.compliance * Mat3::Identity() +
                       (joint.axisCompliance - joint.compliance) * joint.axis * joint.axis.transpose();
  const Mat3 ya = y * angular;
  Mat6 c;
  c.topLeftCorner<3, 3>() = joint.compliance * Mat3::Identity() - ya * y;
  c.topRightCorner<3, 3>() = ya;
  c.bottomLeftCorner<3, 3>() = ya.transpose();
  c.bottomRightCorner<3, 3>() = angular;
  return c;
}

/// row . p is the angular impulse about the axis at the anchor of an impulse p about O.
Vec6 motorRow(const TreeSystem::Joint& joint) {
  Vec6 row;
  row << joint.childAnchor.cross(joint.axis), joint.axis;
  return row;
}

/// Writes the inverse where it is to stand: every step inverts two matrices for each body, and copies add up.
void invertSpd(const Mat6& m, Mat6& result) {
  // L L^T = m, then the columns of L^-1, then L^-T L^-1.
  double l[6][6], inverse[6][6] = {};
  for (int j = 0; j < 6; ++j) {
    double sum = m(j, j);
    for (int k = 0; k < j; ++k) sum -= l[j][k] * l[j][k];
    l[j][j] = 1 / std::sqrt(sum);
    for (int i = j + 1; i < 6; ++i) {
      double s = m(i, j);
      for (int k = 0; k < j; ++k) s -= l[i][k] * l[j][k];
      l[i][j] = s * l[j][j];
    }
  }
  for (int j = 0; j < 6; ++j) {
    inverse[j][j] = l[j][j];
    for (int i = j + 1; i < 6; ++i) {
      double s = 0;
      for (int k = j; k < i; ++k) s -= l[i][k] * inverse[k][j];
      inverse[i][j] = s * l[i][i];
    }
  }
  for (int j = 0; j < 6; ++j)
    for (int i = j; i < 6; ++i) {
      double s = 0;
      for (int k = i; k < 6; ++k) s += inverse[k][i] * inverse[k][j];
      result(i, j) = result(j, i) = s;
    }
}

}  // namespace

Mat6 inverseSpd(const Mat6& m) {
  Mat6 result;
  invertSpd(m, result);
  return result;
}

TreeSystem::TreeSystem(std::vector<int> parents) : parents_(std::move(parents)) {
  for (std::size_t i = 0; i < parents_.size(); ++i)
    if (parents_[i] >= static_cast<int>(i) || (parents_[i] < 0) != (i == 0))
      throw std::invalid_argument("physics: a tree's bodies must come after their parents");
  bodies_.resize(parents_.size());
  joints_.resize(parents_.size());
  factors_.resize(parents_.size());
  ownInertias_.resize(parents_.size());
  momenta_.resize(parents_.size());
  pushes_.resize(parents_.size());
  carried_.resize(parents_.size());
  velocities_.resize(parents_.size());
  impulses_.resize(parents_.size());
}

void TreeSystem::factor() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    ownInertias_[i] = spatialInertia(bodies_[i].mass, bodies_[i].inertia, bodies_[i].position);
    factors_[i].stale = true;
  }
  eliminate();
}

void TreeSystem::freeAxis(int child) {
  joints_[at(child)].axisFree = true;
  factors_[at(child)].stale = true;
}

void TreeSystem::refactor() {
  if (std::ranges::any_of(factors_, &Factor::stale)) eliminate();
}

void TreeSystem::eliminate() {
  inertias_ = ownInertias_;
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    Factor& f = factors_[i];
    f.responseKnown = false;
    if (f.stale) {
      f.stale = false;
      invertSpd(inertias_[i], f.inverseInertia);
      if (i == 0) break;
      const Joint& joint = joints_[i];
      f.gap = joint.parentAnchor - joint.childAnchor;
      invertSpd(f.inverseInertia + complianceAboutOrigin(joint), f.stiffness);
      if (joint.axisFree) {
        // The joint's impulse may have no part about the axis.
        const Vec6 row = motorRow(joint);
        const Vec6 sa = f.stiffness * row;
        f.stiffness -= sa * sa.transpose() / row.dot(sa);
      }
      f.carried = carryToParent(f.stiffness, f.gap);
      f.pathKnown = false;
      factors_[at(parents_[i])].stale = true;
    }
    if (i == 0) break;
    inertias_[at(parents_[i])] += f.carried;
  }
}

const TreeSystem::Factor& TreeSystem::path(int body) {
  Factor& f = factors_[at(body)];
  if (f.pathKnown) return f;
  f.pathKnown = true;
  const Mat6 ms = f.inverseInertia * f.stiffness;
  f.own = f.inverseInertia - ms * f.inverseInertia;
  // up = Z^T S^-1 M^-1
  const Mat6 sm = ms.transpose();
  const Mat3 d = cross(f.gap);
  f.up.topRows<3>() = sm.topRows<3>();
  f.up.bottomRows<3>() = sm.bottomRows<3>() + d * sm.topRows<3>();
  return f;
}

void TreeSystem::solve(double h) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& b = bodies_[i];
    momenta_[i] = spatialImpulse(b.position, b.mass * b.linearVelocity + h * b.force,
                                 b.inertia * b.angularVelocity + h * b.torque);
    pushes_[i].setZero();
    if (i == 0) continue;
    const Joint& joint = joints_[i];
    factors_[i].wanted << joint.linear + joint.childAnchor.cross(joint.angular), joint.angular;
  }
  pass();
}

void TreeSystem::resolve() { pass(); }

void TreeSystem::pass() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) carried_[i] = momenta_[i] + pushes_[i];
  for (std::size_t i = bodies_.size(); i-- > 1;) {
    const Factor& f = factors_[i];
    velocities_[i] = f.inverseInertia * carried_[i];
    carried_[at(parents_[i])] -= impulseToParent(f.stiffness * (f.wanted - velocities_[i]), f.gap);
  }
  velocities_[0] = factors_[0].inverseInertia * carried_[0];
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    const Factor& f = factors_[i];
    impulses_[i] =
        f.stiffness * (f.wanted + velocityOfParent(velocities_[at(parents_[i])], f.gap) - velocities_[i]);
    velocities_[i] += f.inverseInertia * impulses_[i];
  }
}

double TreeSystem::motorImpulse(int child) const {
  return motorRow(joints_[at(child)]).dot(impulses_[at(child)]);
}

const Mat6& TreeSystem::ownResponse(int body) {
  Factor& f = factors_[at(body)];
  if (!f.responseKnown) {
    if (body == 0) {
      f.response = f.inverseInertia;
    } else {
      path(body);
      f.response = f.own + f.up.transpose() * ownResponse(parents_[at(body)]) * f.up;
    }
    f.responseKnown = true;
  }
  return f.response;
}

Mat6 TreeSystem::response(int a, int b) {
  // To the bodies' nearest common ancestor, there, and down again. A larger index is never an ancestor.
  Mat6 fromB = Mat6::Identity(), toA = Mat6::Identity();
  while (a != b) {
    if (a > b) {
      toA = toA * path(a).up.transpose();
      a = parents_[at(a)];
    } else {
      fromB = path(b).up * fromB;
      b = parents_[at(b)];
    }
  }
  return toA * ownResponse(a) * fromB;
}

}  // namespace plumbline::simulation
