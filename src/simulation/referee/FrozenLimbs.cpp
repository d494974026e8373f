#include "simulation/referee/FrozenLimbs.h"

namespace plumbline::simulation {

bool FrozenLimbs::freeze(const Limb& limb, double time, const FreezeTimes& times) {
  bool any = false;
  for (int joint = limb.first; joint <= limb.last; ++joint) {
    double& last = last_[static_cast<std::size_t>(joint)];
    if (time - last <= times.frozen + times.thaw) continue;
    last = time;
    joints_.set(static_cast<std::size_t>(joint));
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
