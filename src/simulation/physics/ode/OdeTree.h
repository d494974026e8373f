#pragma once
#include <vector>

#include "simulation/physics/Physics.h"
#include "simulation/physics/ode/OdeTypes.h"
#include "simulation/physics/tree/TreeSystem.h"

namespace plumbline::simulation::ode {

/// A row of a step's equations outside the tree: impulse and velocity along a direction of one body against
/// another body of the same or another tree, or the world.
struct OutsideRow {
  struct Side {
    class OdeTree* tree = nullptr;  ///< none: the world
    int body = 0;
    Vec6 direction = Vec6::Zero();  ///< impulse about the tree's origin for a row impulse of 1
  };
  Side sides[2];
  double wanted = 0;            ///< relative velocity [m/s, rad/s]
  double compliance = 0;        ///< of velocity by impulse
  double lower = 0, upper = 0;  ///< of the impulse
  int push = -1;                ///< friction with Coulomb's limit: the row of the push, else -1
  double friction = 0;          ///< its coefficient
};

/// One assembly's part in a step: from ODE's bodies and hinges to a tree of equations and back. The equations
/// are those of ODE's dWorldStep (dxStepIsland, the joints' getInfo2).
class OdeTree {
public:
  OdeTree(const Assembly& assembly, const std::vector<dBodyID>& bodies, const std::vector<dJointID>& hinges);

  /// Reads bodies and hinges and solves without rows from outside. Forces on top of gravity come from ODE's
  /// accumulators.
  void begin(const PhysicsConfig& config);
  /// Appends the rows of hinges at their stops and of motors at their limit.
  void appendRows(const PhysicsConfig& config, std::vector<OutsideRow>& rows);
  /// Solves with what was pushed. If motors give more than they can, they get rows of their own and false
  /// comes back: then all is to be done again from solve().
  bool finish(const PhysicsConfig& config);
  /// Forgets pushes, with the motors as they are now.
  void solve(const PhysicsConfig& config);
  /// Moves the bodies by their new velocities.
  void integrate(const PhysicsConfig& config);
  /// Of a hinge. Sensors, commands and the equations of the next step ask for the same one.
  double angle(std::size_t hinge);
  /// To be called when somebody else has moved the bodies.
  void forgetAngles() { anglesKnown_ = false; }

  const Vec3& origin() const { return origin_; }
  TreeSystem& tree() { return tree_; }

private:
  struct HingeFrame {
    HingeSpec spec;
    Vec3 childAnchor, parentAnchor, childAxis, parentAxis;  ///< in the bodies' frames
    int stop = 0;       ///< -1 at or beyond the lower, 1 the upper one, 0 between
    double beyond = 0;  ///< [rad]
    double motorVelocity = 0;
    bool saturated = false;  ///< the motor is a row from outside with its limits
  };

  void readBody(int i, const PhysicsConfig& config);
  void readHinge(std::size_t index, const PhysicsConfig& config);
  void push(TreeSystem::Body& child, TreeSystem::Body& parent, const HingeFrame& hinge, const Vec3& axis);

  std::vector<dBodyID> bodies_;
  std::vector<dJointID> hinges_;
  std::vector<Mat3> inertias_;  ///< in the bodies' frames
  std::vector<double> masses_;
  std::vector<HingeFrame> frames_;
  std::vector<double> angles_;
  bool anglesKnown_ = false;
  TreeSystem tree_;
  Vec3 origin_ = Vec3::Zero();
};

}  // namespace plumbline::simulation::ode
