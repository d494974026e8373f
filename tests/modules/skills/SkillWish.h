#pragma once
#include "representations/behavior/SkillRequest.h"
#include "support/ModuleHarness.h"

namespace plumbline::test {

/// Asks the module for this skill with this target.
template <typename M>
void wish(ModuleHarness<M>& harness, const char* skill, const Pose2& target) {
  harness.template input<SkillRequest>().skill = skill;
  harness.template input<SkillRequest>().target = target;
}

}  // namespace plumbline::test
