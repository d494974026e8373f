#include "modules/infrastructure/CognitionConfigLoader.h"

#include "field/FieldFile.h"

namespace plumbline {

MAKE_MODULE(CognitionConfigLoader)

void CognitionConfigLoader::init() {
  const auto* choice = findObject<FieldChoice>();
  static_cast<FieldSize&>(field_) =
      choice && !choice->file.empty() ? readFieldFile(choice->file) : readFieldSize(config.file("field"));
}

}  // namespace plumbline
