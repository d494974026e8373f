#include "modules/optimization/SearchedMotion.h"

#include <stdexcept>

namespace plumbline {

MAKE_MODULE(SearchedMotion)

void SearchedMotion::take() {
  const OptimizationTrial& trial = *theOptimizationTrial;
  if (!trial.open || trial.number == number_ || !theRobotDescription->known()) return;
  number_ = trial.number;
  const std::string begun = trial.motion + (trial.foot == Side::left ? " left" : " right");
  if (begun != begun_) {
    const auto motions = readMotions(config, theRobotDescription->model);
    const motion::KeyframeMotion* first = findMotion(motions, trial.motion);
    if (!first) return requestStop(2, motion::missingMotion(motions, trial.motion));
    try {
      kick_.emplace(*first, theRobotDescription->model, trial.foot);
    } catch (const std::invalid_argument& error) {
      return requestStop(2, error.what());
    }
    begun_ = begun;
  }
  const auto n = static_cast<Eigen::Index>(trial.parameters.size());
  if (trial.parameters.size() != kick_->list().size())
    return requestStop(2, "the optimiser has " + std::to_string(n) + " parameters, the motion " +
                              trial.motion + " has " + std::to_string(kick_->list().size()));
  motion_ = kick_->written(Eigen::Map<const Eigen::VectorXd>(trial.parameters.data(), n),
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
