#pragma once
#include "situation/Situation.h"

namespace plumbline {

/// What only a supporter's situations have. What is expected of it is a SkillExpected.
struct SupporterKnowledge : KindKnowledge {
  double ballAge = 0;  ///< since anybody saw it [s]
};

}  // namespace plumbline
