#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "motion/Keyframes.h"
#include "motion/MotionParameters.h"
#include "robot/RobotModel.h"
#include "trials/TaskOptions.h"

namespace plumbline {

/// A task of a search, with its options, that an agent can try: which motion is searched, by which numbers.
class AgentTask {
public:
  /// Reads the options as bin/optworker does. Throws ConfigurationError, which begins with "the server's",
  /// for a task that an agent cannot try and for options that are none. An option that an agent does not heed
  /// may only have its default. So one that a task gets in future is refused until the agent heeds it.
  static std::unique_ptr<AgentTask> make(const std::string& task, const TaskOptions& options);
  /// The options of a task that an agent heeds.
  static const std::vector<std::string_view>& heeded(const std::string& task);
  virtual ~AgentTask() = default;

  /// The league's type of the robot that it is for.
  virtual int robotType() const = 0;
  /// Begins with the motion of these that the options name. Throws std::invalid_argument for what is missing.
  virtual void begin(const std::vector<motion::KeyframeMotion>& motions, const RobotModel& robot) = 0;
  /// After begin(): the numbers that are searched.
  virtual const std::vector<motion::SearchedNumber>& list() const = 0;
  /// After begin(): the motion with these, as its file has it; cycle as for MotionParameters::written.
  virtual motion::KeyframeMotion written(const Eigen::VectorXd& values, double cycle) const = 0;
  /// Of the motion that it begins with.
  virtual const std::string& motionName() const = 0;
};

}  // namespace plumbline
