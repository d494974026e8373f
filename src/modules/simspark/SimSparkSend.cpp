#include "modules/simspark/SimSparkSend.h"

namespace plumbline {

MAKE_MODULE(SimSparkSend)

void SimSparkSend::init() {
  link_ = &object<SimSparkLink>();
  command_.syn = true;  // ignored by a server that does not run in sync mode
}

void SimSparkSend::execute() {
  if (!link_->connection.connected()) return;
  for (int joint = 0; joint < numHumanoidJoints; ++joint)
    if (theRobotDescription->model.has(static_cast<JointId>(joint)))
      command_.velocity[joint] = theJointRequestWithSpeeds->speeds[joint];
  command_.beam = theBeamRequest->active ? std::optional(theBeamRequest->pose) : std::nullopt;
  command_.say.reset();
  if (theSayMessage && !theSayMessage->text.empty()) command_.say = theSayMessage->text;
  command_.pass = thePassRequest && thePassRequest->active;
  link_->send(command_);
}

}  // namespace plumbline
