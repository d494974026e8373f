#include "motion/Stillness.h"

namespace plumbline::motion {

bool Stillness::update(const Vec3& gyro) {
  cycles_ = gyro.norm() < stillTurnRate ? cycles_ + 1 : 0;
  return still();
}

}  // namespace plumbline::motion
