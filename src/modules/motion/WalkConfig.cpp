#include "modules/motion/WalkConfig.h"

#include <stdexcept>

#include "framework/ConfigurationError.h"

namespace plumbline {

walking::WalkGaits readWalkGaits(const Config& config) {
  const walking::WalkGaits gaits = walking::readWalkGaits(config.file("walking"));
  try {
    gaits.check();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(std::string("walking.yaml: ") + error.what());
  }
  return gaits;
}

}  // namespace plumbline
