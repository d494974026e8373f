#include "modules/motion/WalkingEngine.h"

#include "framework/ThreadPriority.h"
#include "modules/motion/WalkConfig.h"

namespace plumbline {

MAKE_MODULE(WalkingEngine)

void WalkingEngine::init() {
  gaits_ = readWalkGaits(config);
  const bool fits = config.get<bool>("fit.enabled");
  fitsPlan_ = config.get<bool>("fit.plan");
  walking::BackgroundFitOptions options;
  options.steps = static_cast<std::size_t>(config.get<int>("fit.steps", {6, 10000}));
  options.maxSteps = 3 * options.steps;
  options.duration = config.get<double>("fit.seconds", {0.1, 3600});
  options.cpuShare = config.get<double>("fit.cpuShare", {0.01, 1});
  options.wait = config.get<bool>("fit.wait");
  options.fit.plan = fitsPlan_;
  options.fit.generations = config.get<int>("fit.generations", {1, 100000});
  options.onThreadStart = [] { applyThreadPriority(0, 14); };
  if (fits) fit_ = std::make_unique<walking::BackgroundFit>(options);
}

namespace {

std::optional<walking::FootContact> felt(const FootForceData& sensor) {
  if (!sensor.contact) return std::nullopt;
  return walking::FootContact{sensor.point, sensor.force};
}

}  // namespace

void WalkingEngine::fitModel() {
  if (const walking::ObservedStep* step = engine_->observedStep()) fit_->add(*step);
  const auto result =
      fit_->pass(theFrameInfo->cycleSeconds, engine_->modelParameters(), engine_->prediction());
  if (!result) return;
  engine_->setModelParameters(result->parameters);
  engine_->setPrediction(result->prediction);
  const auto fate = [&result](bool taken) {
    return result->rolledBack ? ", rolled back" : taken ? ", taken" : ", not taken";
  };
  log << "walk model: error on held-out steps, predicting " << result->predictionHeldBefore << " -> "
      << result->predictionHeldAfter << fate(result->predicts);
  if (fitsPlan_)
    log << "; planning " << result->heldBefore << " -> " << result->heldAfter << fate(result->accepted);
}

void WalkingEngine::update(WalkingEngineOutput* theWalkingEngineOutput) {
  if (theRobotDescription->type < 0) return;
  if (theRobotDescription->type != type_) {
    type_ = theRobotDescription->type;
    engine_.emplace(gaits_, theRobotDescription->model);
  }
  const bool selected = theMotionSelection->motion == Motion::walk;
  if (fit_ && !selected && !standing_) fit_->fell();
  standing_ = true;
  if (!selected || theMotionSelection->started || theFrameInfo->restarted) engine_->reset();
  walking::WalkOutput output;
  if (selected) {
    walking::WalkRequest request;
    request.walk = theMotionRequest->motion == Motion::walk;
    request.velocity = theMotionRequest->walkVelocity;
    request.turn = theMotionRequest->walkTurn;
    walking::WalkSensors sensors;
    sensors.angles = theJointData->angles;
    sensors.torsoAngles = Vec2(theTorsoAngles->roll, theTorsoAngles->pitch);
    sensors.gyro = theSensorData->gyro;
    sensors.feet = walking::feltFeet(*theSensorData, felt);
    sensors.dt = theFrameInfo->cycleSeconds;
    output = engine_->update(request, sensors);
    if (fit_ && request.walk) fitModel();
    standing_ = output.standing;
  } else {
    output = engine_->stand();
  }
  theWalkingEngineOutput->targets.angles = output.angles;
  theWalkingEngineOutput->targets.set = output.set;
  theWalkingEngineOutput->odometry = output.odometry;
  theWalkingEngineOutput->standing = output.standing;
  theWalkingEngineOutput->velocity = output.velocity;
  theWalkingEngineOutput->turn = output.turn;
}

}  // namespace plumbline
