#include "modules/optimization/AgentTask.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "motion/SearchedKick.h"
#include "trials/KickOptions.h"
#include "trials/StandUpOptions.h"

namespace plumbline {
namespace {

using Names = std::vector<std::string_view>;

const Names ofKick = {"type",   "motion",  "side",   "direction", "distance", "weight",
                      "steady", "ceiling", "spread", "walk",      "still"};
const Names ofStandUp = {"type", "direction", "motion", "weight", "still"};

[[noreturn]] void refuse(const std::string& task, const std::string& what) {
  throw ConfigurationError("the server's task " + task + " has the option " + what +
                           "; an agent cannot try that, bin/optworker can");
}

/// The options as the task has them, if an agent can try what they ask for.
template <typename Options>
Options heedable(const std::string& task, const TaskOptions& given) {
  Options options;
  try {
    options = given.as<Options>();
  } catch (const ConfigurationError& error) {
    throw ConfigurationError(std::string("the server's task ") + task + ": " + error.what());
  }
  const auto& heeded = AgentTask::heeded(task);
  for (const std::string& name : changedOptions(Options::parameterList(), &options))
    if (std::ranges::find(heeded, name) == heeded.end()) refuse(task, name);
  return options;
}

const motion::KeyframeMotion& motionOf(const std::vector<motion::KeyframeMotion>& motions,
                                       const std::string& name) {
  const motion::KeyframeMotion* found = findMotion(motions, name);
  if (!found) throw std::invalid_argument(motion::missingMotion(motions, name));
  return *found;
}

class KickOfAgent final : public AgentTask {
public:
  explicit KickOfAgent(const TaskOptions& options) : options_(heedable<KickOptions>("kick", options)) {}

  int robotType() const override { return options_.world.robot.type; }
  void begin(const std::vector<motion::KeyframeMotion>& motions, const RobotModel& robot) override {
    kick_.emplace(motionOf(motions, options_.motion), robot, options_.foot());
  }
  const std::vector<motion::SearchedNumber>& list() const override { return kick_->list(); }
  motion::KeyframeMotion written(const Eigen::VectorXd& values, double cycle) const override {
    return kick_->written(values, cycle);
  }
  const std::string& motionName() const override { return options_.motion; }

private:
  KickOptions options_;
  std::optional<motion::SearchedKick> kick_;
};

class StandUpOfAgent final : public AgentTask {
public:
  explicit StandUpOfAgent(const TaskOptions& options)
      : options_(heedable<StandUpOptions>("standUp", options)) {
    // What a roll leads to is the agent's own choice.
    if (options_.side() == 0) refuse("standUp", "direction with the value side");
  }

  int robotType() const override { return options_.world.robot.type; }
  void begin(const std::vector<motion::KeyframeMotion>& motions, const RobotModel& robot) override {
    first_ = motionOf(motions, options_.firstMotion());
    numbers_.emplace(first_, robot);
  }
  const std::vector<motion::SearchedNumber>& list() const override { return numbers_->list(); }
  motion::KeyframeMotion written(const Eigen::VectorXd& values, double cycle) const override {
    return numbers_->written(values, cycle);
  }
  const std::string& motionName() const override { return first_.name; }

private:
  StandUpOptions options_;
  motion::KeyframeMotion first_;
  std::optional<motion::MotionParameters> numbers_;
};

}  // namespace

const std::vector<std::string_view>& AgentTask::heeded(const std::string& task) {
  static const Names none;
  return task == "kick" ? ofKick : task == "standUp" ? ofStandUp : none;
}

std::unique_ptr<AgentTask> AgentTask::make(const std::string& task, const TaskOptions& options) {
  if (task == "kick") return std::make_unique<KickOfAgent>(options);
  if (task == "standUp") return std::make_unique<StandUpOfAgent>(options);
  throw ConfigurationError("the server's task is " + task + "; an agent can try the tasks kick and standUp");
}

}  // namespace plumbline
