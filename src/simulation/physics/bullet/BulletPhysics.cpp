#include "simulation/physics/bullet/BulletPhysics.h"

#include "simulation/physics/AssembliesPhysics.h"
#include "simulation/physics/PhysicsEngine.h"
#include "simulation/physics/bullet/BulletStep.h"

namespace plumbline::simulation::bullet {

namespace {

class BulletPhysics : public AssembliesPhysics<BulletAssembly> {
public:
  explicit BulletPhysics(const PhysicsConfig& config) : AssembliesPhysics(config), contactFinder_(config) {}

  void addGround(Material material) override {
    check(material);
    contactFinder_.addGround(material);
  }
  void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) override {
    check(material);
    contactFinder_.addStatic(shape, T_world_shape, material);
  }

  int addAssembly(const Assembly& assembly, const Pose3& T_world_root) override {
    return add(assembly, assembly, T_world_root);
  }

  void setMotor(int assembly, int hinge, double velocity) override {
    get(assembly).setMotor(hinge, velocity);
  }
  double hingeAngle(int assembly, int hinge) const override { return get(assembly).hingeAngle(hinge); }

  void step() override {
    contactFinder_.find(assemblies);
    if (config.autoDisable) updateSleep();
    stepper_.step(config, assemblies, contactFinder_);
  }
  const std::vector<Contact>& contacts() const override { return contactFinder_.contacts(); }

  BodyState bodyState(int assembly, int body) const override { return get(assembly).bodyState(body); }
  void wake(int assembly, int body) override {
    BulletAssembly& owner = get(assembly);
    owner.bodyState(body);  // there is no such body: out of range
    if (owner.asleep()) owner.wake();
  }

private:
  BulletContacts contactFinder_;
  BulletStep stepper_;
};

}  // namespace

std::unique_ptr<Physics> makeBulletPhysics(const PhysicsConfig& config) {
  return std::make_unique<BulletPhysics>(config);
}

// Another engine, for a second opinion.
MAKE_PHYSICS(bullet, {"bullet", 30, makeBulletPhysics});

}  // namespace plumbline::simulation::bullet
