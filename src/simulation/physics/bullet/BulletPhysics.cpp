#include "simulation/physics/bullet/BulletPhysics.h"

#include <set>
#include <stdexcept>

#include "simulation/physics/bullet/BulletStep.h"

namespace plumbline::simulation::bullet {

namespace {

class BulletPhysics : public Physics {
public:
  explicit BulletPhysics(const PhysicsConfig& config_) : config(config_), contactFinder(config_) {}

  void addGround(Material material) override {
    check(material);
    contactFinder.addGround(material);
  }
  void addStatic(const Shape& shape, const Pose3& T_world_shape, Material material) override {
    check(material);
    contactFinder.addStatic(shape, T_world_shape, material);
  }

  int addAssembly(const Assembly& assembly, const Pose3& T_world_root) override {
    for (const BodySpec& body : assembly.bodies) check(body.material);
    assemblies.emplace(nextHandle, std::make_unique<BulletAssembly>(assembly, T_world_root));
    return nextHandle++;
  }
  void removeAssembly(int assembly) override {
    get(assembly);
    assemblies.erase(assembly);
  }

  void setMotor(int assembly, int hinge, double velocity) override {
    get(assembly).setMotor(hinge, velocity);
  }
  double hingeAngle(int assembly, int hinge) const override { return get(assembly).hingeAngle(hinge); }

  void step() override {
    contactFinder.find(assemblies);
    if (config.autoDisable) doze();
    stepper.step(config, assemblies, contactFinder);
  }
  const std::vector<Contact>& contacts() const override { return contactFinder.contacts(); }

  BodyState bodyState(int assembly, int body) const override { return get(assembly).bodyState(body); }
  AssemblyState state(int assembly) const override { return get(assembly).state(); }
  void setState(int assembly, const AssemblyState& state) override { get(assembly).setState(state); }
  void setVelocities(int assembly, const AssemblyState& state) override {
    get(assembly).setVelocities(state);
  }
  void moveRigidly(int assembly, const Pose3& T_world_root) override {
    get(assembly).moveRigidly(T_world_root);
  }
  void wake(int assembly, int body) override {
    BulletAssembly& owner = get(assembly);
    owner.bodyState(body);  // there is no such body: out of range
    if (owner.asleep()) owner.wake();
  }
  bool asleep(int assembly) const override { return get(assembly).asleep(); }

private:
  void doze() {
    std::set<int> touching;
    for (const Contact& contact : contactFinder.contacts()) {
      touching.insert(contact.assemblyA);
      touching.insert(contact.assemblyB);
    }
    for (const auto& [handle, assembly] : assemblies) assembly->doze(touching.contains(handle));
  }

  void check(Material material) const {
    if (material < 0 || static_cast<std::size_t>(material) >= config.surfaces.size())
      throw std::invalid_argument("physics: no contact surfaces for material " + std::to_string(material));
  }

  BulletAssembly& get(int assembly) const {
    const auto it = assemblies.find(assembly);
    if (it == assemblies.end())
      throw std::out_of_range("physics: no assembly " + std::to_string(assembly) + " in this world");
    return *it->second;
  }

  PhysicsConfig config;
  BulletContacts contactFinder;
  BulletStep stepper;
  Assemblies assemblies;
  int nextHandle = 0;
};

}  // namespace

std::unique_ptr<Physics> makeBulletPhysics(const PhysicsConfig& config) {
  return std::make_unique<BulletPhysics>(config);
}

}  // namespace plumbline::simulation::bullet
