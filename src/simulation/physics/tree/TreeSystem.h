#pragma once
#include <vector>

#include "simulation/physics/tree/Spatial.h"

namespace plumbline::simulation {

/// The equations of one step of bodies joined to a tree, solved in time that grows with the number of bodies.
///
/// Unknown are the bodies' velocities v after the step and the joints' impulses p:
///   M v = M v_before + h f + (impulses of joints and from outside),
///   v_child - v_parent + C p = c   at each joint, in six directions,
/// This is the same linear system that ODE's dWorldStep solves densely for hinges with unlimited motors. C:
/// constraint force mixing divided by h; c: correction of gaps and motor velocity. Bodies are eliminated from
/// the leaves to the root, as in D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996.
class TreeSystem {
public:
  struct Body {
    double mass = 0;
    Mat3 inertia = Mat3::Zero();   ///< about the centre of mass, world axes
    Vec3 position = Vec3::Zero();  ///< of the centre of mass, relative to O
    Vec3 linearVelocity = Vec3::Zero(), angularVelocity = Vec3::Zero();
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();  ///< about the centre of mass
  };

  /// The hinge above a body; anchors relative to O, as the child and as the parent have it.
  struct Joint {
    Vec3 childAnchor = Vec3::Zero(), parentAnchor = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
    Vec3 linear = Vec3::Zero();   ///< wanted velocity of child's against parent's anchor
    Vec3 angular = Vec3::Zero();  ///< wanted relative angular velocity, the motor's along the axis included
    double compliance = 0;        ///< C of all directions but the axis
    double axisCompliance = 0;    ///< C of the motor
    bool axisFree = false;        ///< no motor: nothing but rows from outside acts about the axis
  };

  /// parents[i] < i is the body above body i; parents[0] is -1.
  explicit TreeSystem(std::vector<int> parents);

  Body& body(int i) { return bodies_[at(i)]; }
  Joint& joint(int child) { return joints_[at(child)]; }
  int parent(int i) const { return parents_[at(i)]; }

  /// Prepares everything that does not depend on velocities and forces.
  void factor();
  /// Nothing but rows from outside acts about a joint's axis from now on; to be followed by refactor().
  void freeAxis(int child);
  /// factor() where joints were freed and nothing else has changed: only they and what is above them is
  /// worked out again.
  void refactor();
  /// Solves for bodies, joints and forces as they are, step h [s], without impulses from outside.
  void solve(double h);
  /// Adds an impulse from outside to a body (about O), for resolve().
  void push(int body, const Vec6& impulse) { pushes_[at(body)] += impulse; }
  /// Solves again with the pushes added since solve().
  void resolve();

  const Vec6& velocity(int body) const { return velocities_[at(body)]; }
  /// Impulse of the motor on the child about its axis [N m s].
  double motorImpulse(int child) const;
  /// Change of body a's velocity by an impulse on body b.
  Mat6 response(int a, int b);

private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const Mat6& ownResponse(int body);
  void eliminate();
  void pass();

  std::vector<int> parents_;
  std::vector<Body> bodies_;
  std::vector<Joint> joints_;
  struct Factor {
    Mat6 inverseInertia;     ///< of the body with everything below it
    Mat6 stiffness;          ///< inverse of the joint's S = inverseInertia + C
    Mat6 carried;            ///< what it adds to the parent's inertia
    bool stale = true;       ///< these three are to be worked out
    Mat6 up;                 ///< takes a momentum of the body to its parent
    Mat6 own;                ///< velocity by momentum while the parent is at rest
    bool pathKnown = false;  ///< up and own; only bodies between the root and what is touched need them
    Mat6 response;
    bool responseKnown = false;
    Vec3 gap;     ///< parent's anchor - child's anchor
    Vec6 wanted;  ///< c, about O
  };
  const Factor& path(int body);
  std::vector<Factor> factors_;
  std::vector<Mat6> ownInertias_, inertias_;  ///< of a body; of it and what is below it
  std::vector<Vec6> momenta_, pushes_, carried_, velocities_, impulses_;
};

}  // namespace plumbline::simulation
