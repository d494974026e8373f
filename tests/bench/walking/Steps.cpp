#include <cmath>

#include "bench/walking/Steps.h"

namespace plumbline::bench {

using namespace training;
using namespace walking;

void StepWatch::cycle() {
  const WalkOutput& out = robot_.output;
  if (out.support != support_) {
    if (support_ != Support::both && planned_) {
      const double side = support_ == Support::left ? 1 : -1;
      result_.figures.change += 1000 * Vec2(last_.x() - planned_->x(), -side * (last_.y() - planned_->y()));
    }
    support_ = out.support;
    planned_.reset();
  } else if (support_ != Support::both) {
    last_ = out.stepTarget;
    if (!planned_) planned_ = last_;
  }
  if (const ObservedStep* step = robot_.engine.observedStep()) add(*step);
}
Observed StepWatch::finish() {
  StepFigures& f = result_.figures;
  if (f.steps > 0) {
    const double n = f.steps;
    f.position /= n;
    f.velocity /= n;
    f.change /= n;
    f.footMean /= n;
    f.footAbs /= n;
  }
  return result_;
}

void StepWatch::add(const ObservedStep& step) {
  const Side side = step.begin.supportSide();
  const Vec2 outwards(1, outward(side));
  const auto& end = step.samples.back();
  const WalkState predicted = step.predicted(step.pendulum.with(robot_.engine.prediction()), end.time);
  StepFigures& f = result_.figures;
  f.position += 1000 * outwards.cwiseProduct(predicted.supportFoot().position - end.foot);
  f.velocity += 1000 * outwards.cwiseProduct(predicted.velocity - end.velocity);
  const ReferenceTrajectory& reference = robot_.engine.reference();
  const Vec2 planned = reference.begin[index(other(side))].foot[index(side)].position;
  const Vec2 off = 1000 * outwards.cwiseProduct(end.foot - planned);
  f.footMean += off;
  f.footAbs += off.norm();
  ++f.steps;
  result_.feet[index(side)].push_back(1000 * end.foot);
  if (result_.referenceFeet.size() < 2) result_.referenceFeet.push_back(1000 * planned);
}

std::vector<std::string> cellsOf(const StepFigures& f) {
  return {fmt::format("{:.1f}", f.position.x()), fmt::format("{:.1f}", f.velocity.x()),
          fmt::format("{:.1f}", f.position.y()), fmt::format("{:.1f}", f.velocity.y()),
          fmt::format("{:.2f}", f.change.x()),   fmt::format("{:.2f}", f.change.y())};
}

void append(std::vector<std::string>& cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

const char* nameOf(Fit fit) {
  return fit == Fit::none ? "as it is" : fit == Fit::prediction ? "predicts" : "plans";
}

void FittedWalk::give(WalkEngine& engine, Fit fit) const {
  engine.setPrediction(fit == Fit::none         ? ModelParameters{}
                       : fit == Fit::prediction ? prediction
                                                : predictionOfPlan);
  engine.setModelParameters(fit == Fit::plan ? plan : ModelParameters{});
}

namespace {

/// Two fits while the robot walks so; plans: with what they plan in use, too.
ModelFitResult fitWhileWalking(Walker& robot, const Requests& requests, bool plans,
                               std::vector<double>* errors, std::vector<ObservedStep>* steps) {
  ModelFitResult last;
  robot.engine.setPrediction({});
  robot.engine.setModelParameters({});
  robot.restart();
  BackgroundFit fit({.steps = 60, .maxSteps = 120, .duration = 20, .wait = true});
  int rounds = 0;
  for (double time = 0; (rounds < 2 || fit.onProbation()) && time < 200; time += robot.cycle) {
    if (!robot.step(requests(time))) {
      fit.fell();
      robot.restart();
    }
    if (const ObservedStep* step = robot.engine.observedStep()) {
      fit.add(*step);
      if (steps && rounds == 0 && steps->size() < 60) steps->push_back(*step);
    }
    if (const auto result =
            fit.pass(robot.cycle, robot.engine.modelParameters(), robot.engine.prediction())) {
      if (errors && rounds == 0) *errors = result->bestPrediction;
      robot.engine.setPrediction(result->prediction);
      if (plans) robot.engine.setModelParameters(result->parameters);
      rounds += result->rolledBack ? 0 : 1;
      last = *result;
    }
  }
  return last;
}

}  // namespace

FittedWalk optimise(Walker& robot, const Requests& requests, std::vector<double>* errors,
                    std::vector<ObservedStep>* steps) {
  const ModelFitResult predicts = fitWhileWalking(robot, requests, false, errors, steps),
                       plans = fitWhileWalking(robot, requests, true, nullptr, nullptr);
  return {predicts.prediction, plans.parameters, plans.prediction};
}

WalkRequest forwardBackward(double time) { return {Vec2(std::fmod(time, 6) < 3 ? 0.15 : -0.15, 0), 0, true}; }

}  // namespace plumbline::bench
