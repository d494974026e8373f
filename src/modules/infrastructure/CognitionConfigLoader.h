#pragma once
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

/// Which file tells the sizes of the field; main gives it to the module's objects.
struct FieldChoice {
  std::string file;  ///< empty: field.yaml of the configuration
};

MODULE(CognitionConfigLoader)
  PROVIDES(FieldDimensions)
  PROVIDES(SkillKickParameters)
END_MODULE

/// Representations that come from configuration and stay as they are: config/field.yaml, or the file of
/// FieldChoice, and config/kick.yaml.
class CognitionConfigLoader : public CognitionConfigLoaderBase {
public:
  void init() override;
  void update(FieldDimensions* theFieldDimensions) override { *theFieldDimensions = field_; }
  void update(SkillKickParameters* theSkillKickParameters) override { *theSkillKickParameters = kick_; }

private:
  FieldDimensions field_;
  SkillKickParameters kick_;
};

}  // namespace plumbline
