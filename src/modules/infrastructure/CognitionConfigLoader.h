#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace plumbline {

MODULE(CognitionConfigLoader)
  PROVIDES(FieldDimensions)
END_MODULE

/// Representations that come from configuration and stay as they are: config/field.yaml.
class CognitionConfigLoader : public CognitionConfigLoaderBase {
public:
  void init() override;
  void update(FieldDimensions* theFieldDimensions) override { *theFieldDimensions = field_; }

private:
  FieldDimensions field_;
};

}  // namespace plumbline
