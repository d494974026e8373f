#pragma once
#include <string>
#include <vector>

#include "gap/inference/Claim.h"
#include "gap/inference/HoldOut.h"
#include "gap/inference/Inference.h"

namespace plumbline::gap {

/// An upper bound of what a model could explain: one value of each actuator effect (actuatorEffects), and of
/// each kind named, in every joint, all fitted at once. It says how much of the gap a model could still take
/// in, not where it comes from: so many values also fit what they do not cause.
struct AllJointFit {
  std::size_t parameters = 0;
  double closed = 0;  ///< of recordings left out: mean share that it closes more; negative: less
  std::vector<RecordingLeft> leftOut;  ///< what it leaves of each, without its group
  Claim claim;                         ///< of a recording that was not seen
  Explanation model;                   ///< fitted to all; without values that do nothing

  /// "A further 12 % closes by fitting 66 values of all joints at once; not attributable." Empty where it is
  /// not more than two in a hundred.
  std::string sentence() const;
};

/// Each group is left out in turn; the values are fitted to the others (fitPerJoint). named: where values
/// begin; namedWithout: the same as found without each group; leftOut: what the answer left of recordings
/// left out. options: as of infer(), with the same memory. Only for robots whose base is fixed: empty
/// otherwise.
AllJointFit fitOfAllJoints(const Mechanism& robot, const std::vector<Trial>& trials, const Explanation& named,
                           const std::vector<Explanation>& namedWithout,
                           const std::vector<RecordingLeft>& leftOut, const InferenceOptions& options);

}  // namespace plumbline::gap
