#pragma once
#include "framework/Module.h"
#include "representations/behavior/BehaviorOutput.h"
#include "representations/behavior/SkillRequest.h"

namespace plumbline {

MODULE(BehaviorCombinator)
  REQUIRES_ALL(BehaviorOutput)
  PROVIDES(SkillRequest)
  PROVIDES(BeamRequest)
END_MODULE

/// Takes the first active behaviour in the order of modules.cfg: those for special situations stand before
/// the roles.
class BehaviorCombinator : public BehaviorCombinatorBase {
public:
  void update(SkillRequest* theSkillRequest) override;
  void update(BeamRequest* theBeamRequest) override;

private:
  const BehaviorOutput* active() const;
};

}  // namespace plumbline
