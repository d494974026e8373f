#include "modules/optimization/SearchedMotion.h"

#include <stdexcept>

namespace plumbline {

MAKE_MODULE(SearchedMotion)

void SearchedMotion::take() {
  const OptimizationTrial& trial = *theOptimizationTrial;
  if (!trial.open || trial.number == number_ || !theRobotDescription->known()) return;
  number_ = trial.number;
  if (!task_ || trial.task != begunTask_ || trial.options != begunOptions_) {
    try {
      task_ = AgentTask::make(trial.task, TaskOptions::ofLines(trial.options));
      task_->begin(readMotions(config, theRobotDescription->model), theRobotDescription->model);
    } catch (const std::invalid_argument& error) {
      task_.reset();
      return requestStop(2, error.what());
    }
    begunTask_ = trial.task;
    begunOptions_ = trial.options;
  }
  const auto n = static_cast<Eigen::Index>(trial.parameters.size());
  if (trial.parameters.size() != task_->list().size())
    return requestStop(2, "the optimiser has " + std::to_string(n) + " parameters, the motion " +
                              task_->motionName() + " has " + std::to_string(task_->list().size()));
  motion_ = task_->written(Eigen::Map<const Eigen::VectorXd>(trial.parameters.data(), n),
                           theFrameInfo->cycleSeconds);
}

void SearchedMotion::update(SearchedMotionOutput* theSearchedMotionOutput) {
  take();
  const bool still = stillness_.update(theSensorData->gyro);
  if (theMotionSelection->motion == SearchedMotionOutput::name) {
    if (theMotionSelection->started) player_.start(motion_, theJointData->angles);
    player_.step(theFrameInfo->cycleSeconds, still);
  }
  theSearchedMotionOutput->ball = motion_.ball;
  theSearchedMotionOutput->targets.angles = player_.angles();
  theSearchedMotionOutput->targets.set = player_.joints();
  theSearchedMotionOutput->finished = player_.finished();
}

}  // namespace plumbline
