#pragma once
#include "framework/Module.h"
#include "representations/behavior/BehaviorOutput.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(BehaviorCombinator)
  REQUIRES_ALL(BehaviorOutput)
  REQUIRES_IF_PROVIDED(FieldDimensions)
  REQUIRES_IF_PROVIDED(RobotPose)
  REQUIRES_IF_PROVIDED(BallPos)
  REQUIRES_IF_PROVIDED(PlayerRole)
  PROVIDES(SkillRequest)
  PROVIDES(BeamRequest)
END_MODULE

/// Takes the first active behaviour in the order of modules.cfg: those for special situations stand before
/// the roles. Whatever a behaviour wants, a player that may not be in the own penalty area (PlayerRole)
/// leaves it, or waits before it.
class BehaviorCombinator : public BehaviorCombinatorBase {
public:
  void update(SkillRequest* theSkillRequest) override;
  void update(BeamRequest* theBeamRequest) override;

private:
  const BehaviorOutput* active() const;
  void keepOutOfArea(SkillRequest& request) const;
};

}  // namespace plumbline
