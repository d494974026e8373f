#include "modules/motion/WalkConfig.h"

namespace plumbline {

walking::WalkParameters readWalkParameters(const Config& config) {
  walking::WalkParameters parameters;
  const ConfigSection& file = config.file("walking");
  for (const walking::WalkParameterInfo& info : walking::walkParameterTable())
    parameters.*info.value = file.get<double>(info.name, {info.low, info.high});
  return parameters;
}

}  // namespace plumbline
