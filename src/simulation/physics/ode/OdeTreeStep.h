#pragma once
#include <vector>

#include "simulation/physics/ode/OdeContacts.h"
#include "simulation/physics/tree/BoundedSystem.h"
#include "simulation/physics/tree/CoulombFriction.h"

namespace plumbline::simulation::ode {

/// One step of everything that is awake. Assemblies that touch make an island; an island's free movement is
/// solved tree by tree, then contacts, stops and motors at their limit in one bounded system over what they
/// do to the trees. The solution is that of ODE's dWorldStep up to rounding, in a fraction of its time: that
/// has a row in one dense matrix for each direction of each hinge.
class OdeTreeStep {
public:
  void step(const PhysicsConfig& config, const Assemblies& assemblies, OdeContacts& contacts);

private:
  /// A tree of the island and how rows from outside reach it.
  struct Member {
    struct Entry {
      Eigen::Index row;
      std::size_t touched;
      Vec6 direction;
    };
    OdeAssembly* assembly;
    std::vector<int> touched;  ///< bodies
    std::vector<Mat6>
        responses;  ///< [i * (i + 1) / 2 + j]: of touched body i to an impulse on touched j <= i
    std::vector<Entry> entries;
  };

  void stepIsland(const PhysicsConfig& config, OdeContacts& contacts);
  void appendContactRows(const PhysicsConfig& config, const OdeContacts& contacts, std::size_t index);
  void distributeRows();
  void solveRows();
  OdeTree* treeOf(int handle);

  Islands<OdeAssembly> islands_;
  std::vector<Member> members_;
  std::vector<std::size_t> contactIndices_;  ///< of the island
  std::vector<OutsideRow> rows_;
  std::vector<Vec6> answer_;
  std::vector<FrictionLimit> frictionLimits_;
  BoundedSystem system_;
};

}  // namespace plumbline::simulation::ode
