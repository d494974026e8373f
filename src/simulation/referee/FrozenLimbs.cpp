#include "simulation/referee/FrozenLimbs.h"

namespace plumbline::simulation {

bool FrozenLimbs::freeze(const Limb& limb, double time, const FreezeTimes& times) {
  bool any = false;
  for (std::size_t joint = 0; joint < maxJoints; ++joint) {
    double& last = last_[joint];
    if (!limb.test(joint) || time - last <= times.frozen + times.thaw) continue;
    last = time;
    joints_.set(joint);
    any = true;
  }
  return any;
}

void FrozenLimbs::thaw(double time, const FreezeTimes& times, bool all) {
  for (std::size_t joint = 0; joint < maxJoints; ++joint) {
    const double since = time - last_[joint];
    if (all || since >= times.frozen) joints_.reset(joint);
    if (all || since >= times.frozen + times.thaw) last_[joint] = never;
  }
}

}  // namespace plumbline::simulation
