#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "representations/motion/Motion.h"

namespace plumbline {

/// Which motion drives the joints.
REPRESENTATION(MotionSelection)
class MotionSelection : public MotionSelectionBase {
public:
  std::string motion = Motion::stand;
  std::vector<std::string> motions;  ///< all that the agent has, in the order of modules.cfg
  std::vector<double> ratios;        ///< of each; they sum to 1 while one motion fades into the next
  std::string specialAction;
  bool started = false;  ///< the motion was switched to in this cycle

  /// 0 for a motion that there is not.
  double ratio(const std::string& name) const {
    for (std::size_t m = 0; m < motions.size(); ++m)
      if (motions[m] == name) return ratios[m];
    return 0;
  }
  std::string problem() const {
    if (ratios.size() == motions.size()) return {};
    return "ratios: " + std::to_string(ratios.size()) + " for " + std::to_string(motions.size()) + " motions";
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(motion);
    STREAM(motions);
    STREAM(ratios);
    STREAM(specialAction);
    STREAM(started);
  }
};

}  // namespace plumbline
