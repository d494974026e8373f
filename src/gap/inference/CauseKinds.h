#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/inference/Groups.h"

namespace plumbline::gap {

/// A kind of cause with the unit that its strength is counted in.
struct CauseKind {
  Cause cause;                  ///< at one unit
  double unit = 0;              ///< strength (Effect::strengthOf) of the middle of its effect's starts
  double lower = 0, upper = 0;  ///< bounds of a value, in units
  /// Joints whose channels show its sensitivity; empty: all.
  std::vector<int> joints;
  /// Minus the log prior of what it has in addition to others: of the recordings it is inactive in.
  double price = 0;
};

/// All that are possible; those of the body's sensors have the joint -1.
std::vector<CauseKind> causeKinds(const Groups& groups, const Mechanism& robot);
/// A setting with its strength as the unit, inactive where it is (Cause::inactiveIn).
CauseKind configuredKind(const Groups& groups, const Mechanism& robot, const Cause& setting);
/// Those that windows can show: all but for what sensors of the body do.
std::vector<CauseKind> windowKinds(const Groups& groups, const Mechanism& robot);
/// Whether those are few: then they are looked at in windows and fitted set by set; else quick replays have
/// long steps (withLongSteps).
bool hasFewKinds(const Groups& groups, const Mechanism& robot);

/// The cause that is x units strong.
Cause causeAt(const Mechanism& robot, const CauseKind& kind, double x);

/// Kinds in as few groups as possible whose members show at different joints: each group is replayed at once
/// (coloured differences: Curtis, Powell and Reid, "On the estimation of sparse Jacobian matrices", 1974).
std::vector<std::vector<std::size_t>> colours(const std::vector<CauseKind>& kinds,
                                              const std::vector<std::size_t>& wanted);

}  // namespace plumbline::gap
