#pragma once
#include <optional>
#include <string>
#include <vector>

#include "motion/Keyframes.h"
#include "parameters/Parameter.h"

namespace plumbline::motion {

/// Which motions bring a lying robot onto its feet, and when it tries again.
struct StandUpParameters {
  PARAMETERS(StandUpParameters)
  PARAMETER(std::string, front, "standUpFront", "", Range(),
            "motion of motions/ for a robot that lies on its front; empty: it stays there")
  PARAMETER(std::string, back, "standUpBack", "", Range(), "for one on its back; empty: it stays there")
  PARAMETER(std::string, side, "rollOver", "", Range(),
            "for one on its side: rolls it onto its back or front, from where it stands up; empty: it stays "
            "there")
  PARAMETER(std::string, fastFront, std::string(), "", Range(),
            "the first try in place of `front`, as standUpFrontFast; empty: none")
  PARAMETER(std::string, fastBack, std::string(), "", Range(),
            "the first try in place of `back`, as standUpBackFast; empty: none")
  PARAMETER(double, againSeconds, 4, "s", Range(0, 60),
            "if a robot lies again within this time after standing up, that try failed, and the next one is "
            "the other motion")
  PARAMETER(double, graceSeconds, 0.5, "s", Range(0, 5),
            "time until the next try, since a stand-up ends while the torso still swings up; none after a "
            "motion for the side")
};

/// The first parameter that names a motion which is not among `motions`, and an error text.
struct MissingStandUp {
  std::string parameter, problem;
};
std::optional<MissingStandUp> missingStandUp(const StandUpParameters& parameters,
                                             const std::vector<KeyframeMotion>& motions);

enum class LyingOn { front, back, side };

/// Whether there is a motion for a robot that lies so.
bool standsUpFrom(const StandUpParameters& parameters, LyingOn how);

/// The side on which a robot lies, by the world's vertical in the torso frame (unit): as FallDetector has it.
LyingOn lyingOn(const Vec3& up);

/// Which motion a lying robot plays next: the fast one first, then in turn the other one and the fast one, as
/// the same motion may fail for ever in the same way. A motion for the side is no try.
class StandUpChoice {
public:
  /// The fast motions are chosen only if they are among `motions`.
  void learn(const StandUpParameters& parameters, const std::vector<KeyframeMotion>& motions);

  /// The next motion's name. again: the robot lies again soon after the last one.
  const std::string& next(const StandUpParameters& parameters, LyingOn how, bool again);
  /// The last choice of next() was a motion for the side: the robot lies after it, and stands up at once.
  bool rolled() const { return rolled_; }
  /// Forgets the tries before, not the motions.
  void forget();

private:
  bool fastFront_ = false, fastBack_ = false;  ///< the robot has them
  bool rolled_ = false;
  int failed_ = 0;  ///< stand-ups in a row that did not keep it on its feet
};

}  // namespace plumbline::motion
