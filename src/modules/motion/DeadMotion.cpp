#include "modules/motion/DeadMotion.h"

namespace plumbline {

MAKE_MODULE(DeadMotion)

void DeadMotion::update(DeadMotionOutput* theDeadMotionOutput) {
  theDeadMotionOutput->targets.set.fill(true);
  theDeadMotionOutput->targets.stiffness.fill(0);
}

}  // namespace plumbline
