#include "modules/infrastructure/CognitionConfigLoader.h"

#include "field/FieldFile.h"

namespace plumbline {

MAKE_MODULE(CognitionConfigLoader)

void CognitionConfigLoader::init() {
  const auto* choice = findObject<FieldChoice>();
  static_cast<FieldSize&>(field_) =
      choice && !choice->file.empty() ? readFieldFile(choice->file) : readFieldSize(config.file("field"));

  const ConfigSection& kick = config.file("kick");
  kick_.ballPosition = {kick.get<double>("ballX", {0, 1}), kick.get<double>("ballY", {-1, 0})};
  kick_.tolerance = {kick.get<double>("toleranceX", {0.001, 1}), kick.get<double>("toleranceY", {0.001, 1})};
  kick_.headingTolerance = kick.get<double>("headingTolerance", {0.001, 3.2});
  kick_.distance = kick.get<double>("distance", {0.1, 30});
}

}  // namespace plumbline
