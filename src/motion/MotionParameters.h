#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "motion/Keyframes.h"
#include "robot/RobotModel.h"

namespace plumbline::motion {

/// A number that is searched, and where.
struct SearchedNumber {
  std::string name;
  double start = 0, lower = 0, upper = 0;
  double sigma = 0;  ///< standard deviation of the first candidates
};

/// Whether joints that mirror each other in a keyframe of a motion are one number or two.
enum class Sides { together, apart };

/// The numbers of a keyframe motion that a search may change: each keyframe's time, its wait to settle if it
/// has one, and its angles. The head is left out. Times in milliseconds, angles in degrees, so that all have
/// steps of about the same worth.
class MotionParameters {
public:
  MotionParameters(KeyframeMotion motion, const RobotModel& robot, Sides sides = Sides::together);

  const std::vector<SearchedNumber>& list() const { return list_; }
  /// The motion with these numbers as its file has it: rounded as motionFile rounds, without keyframes that
  /// take less than half a cycle [s], which have no effect.
  KeyframeMotion written(const Eigen::VectorXd& values, double cycle) const;

private:
  struct Place {
    std::size_t keyframe;
    enum class What { seconds, settle, joint } what;
    JointId joint = noJoint;
    bool both = false;  ///< the mirrored joint follows
  };
  void add(const Place& place, const std::string& name, double start, double lower, double upper,
           double sigma);

  KeyframeMotion motion(const Eigen::VectorXd& values) const;

  KeyframeMotion motion_;
  Sides sides_;
  std::vector<Place> places_;
  std::vector<SearchedNumber> list_;
};

/// A motion as the YAML file that readKeyframeFile reads, below comment lines of `heading`; tenths of a
/// degree, milliseconds, millimetres.
std::string motionFile(const KeyframeMotion& motion, const RobotModel& robot, const std::string& heading);

}  // namespace plumbline::motion
