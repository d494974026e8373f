#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace plumbline {

/// The file with the sizes of the field; main gives it to the module's objects.
struct FieldChoice {
  std::string file;  ///< empty: field.yaml of the configuration
};

MODULE(CognitionConfigLoader)
  PROVIDES(FieldDimensions)
END_MODULE

/// Representations that come from configuration and stay as they are: config/field.yaml, or the file of
/// FieldChoice.
class CognitionConfigLoader : public CognitionConfigLoaderBase {
public:
  void init() override;
  void update(FieldDimensions* theFieldDimensions) override { *theFieldDimensions = field_; }

private:
  FieldDimensions field_;
};

}  // namespace plumbline
