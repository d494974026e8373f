#include "modules/optimization/AgentTask.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "motion/SearchedKick.h"
#include "trials/KickOptions.h"

namespace plumbline {
namespace {

const std::vector<std::string_view> ofKick = {"type",     "motion", "side",   "direction",
                                              "distance", "weight", "steady", "ceiling",
                                              "spread",   "walk",   "still"};

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
    if (std::ranges::find(heeded, name) == heeded.end())
      throw ConfigurationError("the server's task " + task + " has the option " + name +
                               "; an agent cannot try that, bin/optworker can");
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

}  // namespace

const std::vector<std::string_view>& AgentTask::heeded(const std::string& task) {
  static const std::vector<std::string_view> none;
  return task == "kick" ? ofKick : none;
}

std::unique_ptr<AgentTask> AgentTask::make(const std::string& task, const TaskOptions& options) {
  if (task == "kick") return std::make_unique<KickOfAgent>(options);
  throw ConfigurationError("the server's task is " + task + "; an agent can try kicks (task kick)");
}

}  // namespace plumbline
