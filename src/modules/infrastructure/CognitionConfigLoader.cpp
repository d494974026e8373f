#include "modules/infrastructure/CognitionConfigLoader.h"

namespace plumbline {

MAKE_MODULE(CognitionConfigLoader)

void CognitionConfigLoader::init() {
  const ConfigSection& field = config.file("field");
  field_.length = field.get<double>("length", {1, 1000});
  field_.width = field.get<double>("width", {1, 1000});
  field_.goalWidth = field.get<double>("goalWidth", {0.1, 100});
  field_.goalDepth = field.get<double>("goalDepth", {0.1, 100});
  field_.goalHeight = field.get<double>("goalHeight", {0.1, 100});
  field_.penaltyDepth = field.get<double>("penaltyDepth", {0.1, 100});
  field_.penaltyWidth = field.get<double>("penaltyWidth", {0.1, 100});
  field_.centreCircleRadius = field.get<double>("centreCircleRadius", {0.1, 100});
  field_.ballRadius = field.get<double>("ballRadius", {0.001, 1});
}

}  // namespace plumbline
