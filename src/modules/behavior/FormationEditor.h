#pragma once
#include <optional>

#include "framework/AgentDebug.h"
#include "framework/Module.h"
#include "modules/behavior/formation/FormationFile.h"

namespace plumbline {

MODULE(FormationEditor)
END_MODULE

/// The formation's file in the debug interface, for a page that moves places: `formation` is the file, and
/// setting it writes the file. What is impossible is refused, and then nothing has changed. The players take
/// it over by `reload formation`.
class FormationEditor : public FormationEditorBase {
public:
  ~FormationEditor() override;
  void init() override;
  void execute() override;

private:
  AgentDebug* agent_ = nullptr;
  std::optional<FormationFile> file_;
  DebugPoint point_{"formation", DebugKind::parameter};
};

}  // namespace plumbline
