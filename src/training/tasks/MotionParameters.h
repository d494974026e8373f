#pragma once
#include <string>
#include <vector>

#include "motion/Keyframes.h"
#include "robot/RobotModel.h"
#include "training/SearchTask.h"

namespace plumbline::training {

/// The numbers of a keyframe motion that a search may change: each keyframe's time, its wait to settle if it
/// has one, and its angles; where left and right mirror each other they stay so and are one number. The head
/// is left out. Times in milliseconds, angles in degrees, so that all have steps of about the same worth.
class MotionParameters {
public:
  MotionParameters(motion::KeyframeMotion motion, const RobotModel& robot);

  const std::vector<TaskParameter>& list() const { return list_; }
  /// The motion with these numbers.
  motion::KeyframeMotion motion(const Eigen::VectorXd& values) const;
  /// The same without keyframes that take less than half a cycle [s]: their time is as good as nothing.
  motion::KeyframeMotion shortened(const Eigen::VectorXd& values, double cycle) const;

private:
  struct Place {
    std::size_t keyframe;
    enum class What { seconds, settle, joint } what;
    JointId joint = noJoint;
    bool both = false;  ///< the mirrored joint follows
  };
  void add(const Place& place, const std::string& name, double start, double lower, double upper,
           double sigma);

  motion::KeyframeMotion motion_;
  std::vector<Place> places_;
  std::vector<TaskParameter> list_;
};

/// A motion as the YAML file that readKeyframeFile reads, below comment lines of `heading`; tenths of a
/// degree and milliseconds.
std::string motionFile(const motion::KeyframeMotion& motion, const RobotModel& robot,
                       const std::string& heading);

}  // namespace plumbline::training
