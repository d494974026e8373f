#pragma once
#include "framework/Module.h"
#include "representations/behavior/BehaviorOutputs.h"
#include "representations/behavior/SkillRequest.h"

namespace plumbline {

MODULE(BehaviorCombinator)
REQUIRES(BeforeKickOffOutput)
REQUIRES(StrikerOutput)
PROVIDES(SkillRequest)
PROVIDES(BeamRequest)
END_MODULE

/// Takes the first active behaviour, those for special situations before the roles.
class BehaviorCombinator : public BehaviorCombinatorBase {
public:
  void update(SkillRequest* theSkillRequest) override;
  void update(BeamRequest* theBeamRequest) override;

private:
  const BehaviorOutput* active() const;
};

}  // namespace plumbline
