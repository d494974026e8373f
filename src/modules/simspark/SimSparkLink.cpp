#include "modules/simspark/SimSparkLink.h"

#include "framework/ModuleObjects.h"

namespace plumbline {

MAKE_MODULE_OBJECT(SimSparkLink, SimSparkLink)

void SimSparkLink::send(const simspark::AgentCommand& command) {
  text_.clear();
  simspark::appendAgentCommand(text_, command);
  connection.send(text_);
}

}  // namespace plumbline
