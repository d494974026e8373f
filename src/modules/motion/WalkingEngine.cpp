#include "modules/motion/WalkingEngine.h"

#include "framework/DrawingSite.h"
#include "framework/ThreadPriority.h"
#include "modules/motion/WalkConfig.h"
#include "modules/motion/WalkDrawing.h"
#include "walking/planning/SpeedLimits.h"

namespace plumbline {

MAKE_MODULE(WalkingEngine)

void WalkingEngine::parametersChanged() {
  if (!used_) return;
  walking::WalkGaits wanted = walk;
  for (const walking::WalkParameter& one : walking::walkParameters()) {
    for (std::size_t i = 0; i < walking::WalkGaits::numCorners; ++i)
      if (one.of(used_->corner[i]) == one.of(used_->base) && one.of(walk.corner[i]) == one.of(used_->base))
        one.of(wanted.corner[i]) = one.of(walk.base);
  }
  wanted.check();
  if (engine_) engine_->setGaits(wanted);
  used_ = walk = wanted;
}

void WalkingEngine::init() {
  if (config.exists("WalkingEngine") && config.has("walk"))
    config.fail("walk", "is set in walking.yaml, for all programs that walk");
  walk = readWalkGaits(config);
  used_ = walk;
  walking::BackgroundFitOptions options;
  options.steps = static_cast<std::size_t>(fit.steps);
  options.maxSteps = 3 * options.steps;
  options.duration = fit.seconds;
  options.cpuShare = fit.cpuShare;
  options.wait = fit.wait;
  options.fit.plan = fit.plan;
  options.fit.generations = fit.generations;
  options.onThreadStart = [] { applyThreadPriority(0, 14); };
  if (fit.enabled) fit_ = std::make_unique<walking::BackgroundFit>(options);
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
  log << "walk model: error on steps left out of the fit, predicting " << result->predictionLeftOutBefore
      << " -> " << result->predictionLeftOutAfter << fate(result->predicts);
  if (fit.plan)
    log << "; planning " << result->leftOutBefore << " -> " << result->leftOutAfter << fate(result->accepted);
}

void WalkingEngine::update(WalkingEngineOutput* theWalkingEngineOutput) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    engine_.emplace(walk, theRobotDescription->model);
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
    MODIFY("module:WalkingEngine:velocity", request.velocity);
    MODIFY("module:WalkingEngine:turn", request.turn);
    walking::WalkSensors sensors;
    sensors.angles = theJointData->angles;
    sensors.torsoAngles = Vec2(theTorsoAngles->roll, theTorsoAngles->pitch);
    sensors.gyro = theSensorData->gyro;
    sensors.feet = walking::feltFeet(*theSensorData, felt);
    sensors.feet->shear = theSensorData->shear;
    sensors.dt = theFrameInfo->cycleSeconds;
    output = engine_->update(request, sensors);
    if (fit_ && request.walk) fitModel();
    standing_ = output.standing;
    OUTPUT("module:WalkingEngine:standing", standing_);
    DEBUG_DRAWING("draw:WalkingEngine:walk", drawWalk(drawing, *engine_));
    DEBUG_DRAWING("draw:WalkingEngine:steps", if (!output.standing) drawPlannedSteps(drawing, *engine_, 6));
  } else {
    output = engine_->stand();
  }
  theWalkingEngineOutput->targets.angles = output.angles;
  theWalkingEngineOutput->targets.set = output.set;
  theWalkingEngineOutput->targets.stiffness = output.stiffness;
  theWalkingEngineOutput->leftShare = output.leftShare();
  theWalkingEngineOutput->odometry = output.odometry;
  theWalkingEngineOutput->finished = output.standing;
  theWalkingEngineOutput->fadeSeconds = fadeSeconds;
  theWalkingEngineOutput->velocity = output.velocity;
  theWalkingEngineOutput->turn = output.turn;
  theWalkingEngineOutput->limits = walking::walkLimits(walk.base);
}

}  // namespace plumbline
