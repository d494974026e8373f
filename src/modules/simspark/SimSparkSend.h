#pragma once
#include "framework/Module.h"
#include "modules/simspark/SimSparkLink.h"
#include "representations/behavior/PassRequest.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/communication/TeamBelief.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SimSparkInfo.h"
#include "representations/motion/JointRequest.h"

namespace plumbline {

MODULE(SimSparkSend)
  REQUIRES(SimSparkInfo)
  REQUIRES(RobotDescription)
  REQUIRES(JointRequestWithSpeeds)
  REQUIRES(BeamRequest)
  REQUIRES_IF_PROVIDED(SayMessage)
  REQUIRES_IF_PROVIDED(PassRequest)
END_MODULE

/// Ends the cycle: hinge speeds, beam, words, the call for a pass and synchronisation in one message to the
/// simulator.
class SimSparkSend : public SimSparkSendBase {
public:
  void init() override;
  void execute() override;

private:
  SimSparkLink* link_ = nullptr;
  simspark::AgentCommand command_;
};

}  // namespace plumbline
