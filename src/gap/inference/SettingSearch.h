#pragma once
#include <vector>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// Settings of servos (Effect::setting) that may belong to a set, or in the place of the same effect in it,
/// best first. Of each effect it is the one that takes away most of the squares of positions: in all joints
/// alike, if that is nearly as good as in a single one. A setting need not have been in force in each
/// recording (Cause::inactiveIn): it is proposed without the one that loses most, without the two that do,
/// and so on. A limit can be right in a narrow range alone, so each is replayed at many strengths, in all
/// joints at once.
///
/// None that takes away less than a fifth of a recording's squares. By squares and not by the score: while
/// other values are wrong, a wrong limit can have as good a score as the right one (doc/decisions/0023).
std::vector<Cause> proposedSettings(const Replayer& replayer, const Explanation& base, std::size_t most);

}  // namespace plumbline::gap
