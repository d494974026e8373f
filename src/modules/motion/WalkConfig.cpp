#include "modules/motion/WalkConfig.h"

namespace plumbline {

walking::WalkGaits readWalkGaits(const Config& config) {
  return walking::readWalkGaits(config.file("walking"));
}

}  // namespace plumbline
