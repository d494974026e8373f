#include "simulation/physics/ode/OdePhysics.h"

#include <cstdarg>
#include <stdexcept>

#include "simulation/physics/AssembliesPhysics.h"
#include "simulation/physics/PhysicsEngine.h"
#include "simulation/physics/ode/OdeContacts.h"
#include "simulation/physics/ode/OdeTreeStep.h"

namespace plumbline::simulation::ode {

namespace {

static_assert(sizeof(dReal) == sizeof(double), "the league's physics needs ODE in double precision");

/// An error for which ODE would end the program: mostly infinite numbers after impossible settings.
void failLoudly(int, const char*, va_list) {
  throw std::runtime_error("ODE: the simulation became unstable; check its settings");
}

/// A world of ODE that goes when its owner goes.
struct OwnedWorld {
  OwnedWorld() {
    ensureThread();
    dSetErrorHandler(&failLoudly);
    dSetDebugHandler(&failLoudly);
    id = dWorldCreate();
    // ODE's default one is shared by all worlds and breaks when two of them step at the same time.
    threading = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(id, dThreadingImplementationGetFunctions(threading), threading);
  }
  ~OwnedWorld() {
    dWorldDestroy(id);
    dThreadingFreeImplementation(threading);
  }
  OwnedWorld(const OwnedWorld&) = delete;
  OwnedWorld& operator=(const OwnedWorld&) = delete;
  dWorldID id;
  dThreadingImplementationID threading;
};

class OdePhysics : public AssembliesPhysics<OdeAssembly> {
public:
  OdePhysics(const PhysicsConfig& given, Solver solver)
      : AssembliesPhysics(given), solver_(solver), contactFinder_(world_.id, config) {
    dWorldSetGravity(world_.id, config.gravity.x(), config.gravity.y(), config.gravity.z());
    dWorldSetERP(world_.id, config.constraintErp);
    dWorldSetCFM(world_.id, config.constraintCfm);
    dWorldSetContactSurfaceLayer(world_.id, config.surfaceLayer);
    dWorldSetAutoDisableFlag(world_.id, config.autoDisable && solver_ == Solver::dense ? 1 : 0);
  }

  ~OdePhysics() override { assemblies.clear(); }  // before their world goes

  void addGround(Material material) override {
    check(material);
    contactFinder_.addGround(material);
  }
  void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) override {
    check(material);
    contactFinder_.addStatic(shape, T_world_shape, material);
  }

  int addAssembly(const Assembly& assembly, const Pose3& T_world_root) override {
    ensureThread();
    return add(assembly, world_.id, assembly, T_world_root);
  }

  void setMotor(int assembly, int hinge, double velocity) override {
    dJointSetHingeParam(get(assembly).hinge(hinge), dParamVel, velocity);
  }
  double hingeAngle(int assembly, int hinge) const override { return get(assembly).hingeAngle(hinge); }

  void step() override {
    ensureThread();
    for (const auto& [handle, assembly] : assemblies) assembly->applyDrag(config.stepSeconds);
    contactFinder_.find(assemblies);
    if (solver_ == Solver::tree) {
      if (config.autoDisable) updateSleep();
      treeStep_.step(config, assemblies, contactFinder_);
      return;
    }
    contactFinder_.makeJoints();
    dWorldStep(world_.id, config.stepSeconds);
    for (const auto& [handle, assembly] : assemblies) assembly->tree().forgetAngles();
    contactFinder_.takeForces();
  }
  const std::vector<Contact>& contacts() const override { return contactFinder_.contacts(); }

  BodyState bodyState(int assembly, int body) const override {
    dBodyID id = get(assembly).body(body);
    return {bodyPose(id), toVec3(dBodyGetLinearVel(id)), toVec3(dBodyGetAngularVel(id))};
  }
  void wake(int assembly, int body) override {
    OdeAssembly& owner = get(assembly);
    if (!dBodyIsEnabled(owner.body(body))) owner.wake(body);
  }

private:
  Solver solver_;
  OwnedWorld world_;
  OdeContacts contactFinder_;
  OdeTreeStep treeStep_;
};

}  // namespace

std::unique_ptr<Physics> makeOdePhysics(const PhysicsConfig& config, Solver solver) {
  return std::make_unique<OdePhysics>(config, solver);
}

// As the league's server; and the same with ODE's own solver, which is slower.
MAKE_PHYSICS(ode,
             {"ode", 10, [](const PhysicsConfig& config) { return makeOdePhysics(config, Solver::tree); }});
MAKE_PHYSICS(odeDense, {"ode-dense", 20,
                        [](const PhysicsConfig& config) { return makeOdePhysics(config, Solver::dense); }});

}  // namespace plumbline::simulation::ode
