#include <cmath>

#include "bench/walking/Steps.h"

namespace plumbline::bench {

using namespace training;
using namespace walking;

void figuresOfFit(const Subject& subject, Page& page) {
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  std::vector<double> errors;
  std::vector<ObservedStep> steps;
  const ModelParameters fit = optimise(robot, forwardBackward, &errors, &steps).prediction;
  Plot curve{.title = "error of the best parameters so far",
             .xLabel = "generation",
             .yLabel = "mean squared error",
             .series = {}};
  Series& least = curve.add("optimisation");
  for (std::size_t i = 0; i < errors.size(); ++i) least.points.emplace_back(i + 1, errors[i]);
  Series& neutral = curve.add("parameters not changed", Series::Style::dashed);
  const double before = predictionError(steps, {});
  neutral.points = {Vec2(1, before), Vec2(static_cast<double>(errors.size()), before)};
  page.figures.push_back(
      {"Figure 4.13: the least error during an optimisation, " + subject.name + ".", {curve}});

  Page::Figure figure{
      "Figure 4.14: velocities of observed steps and what the model predicts from the beginning of each, " +
          subject.name + ".",
      {}};
  for (const int axis : {0, 1}) {
    Plot plot{.title = axis == 0 ? "forward" : "sideways",
              .xLabel = "time, steps in a row [s]",
              .yLabel = "velocity [m/s]",
              .series = std::vector<Series>(3)};
    plot.series[0].name = "observed";
    plot.series[1].name = "model as it is";
    plot.series[2].name = "optimised";
    double offset = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(16, steps.size()); ++i) {
      const ObservedStep& step = steps[i];
      for (Series& s : plot.series) s.points.emplace_back(offset, step.begin.velocity[axis]);
      for (const ObservedStep::Sample& sample : step.samples) {
        plot.series[0].points.emplace_back(offset + sample.time, sample.velocity[axis]);
        plot.series[1].points.emplace_back(
            offset + sample.time, step.predicted(step.pendulum.with({}), sample.time).velocity[axis]);
        plot.series[2].points.emplace_back(
            offset + sample.time, step.predicted(step.pendulum.with(fit), sample.time).velocity[axis]);
      }
      offset += step.samples.back().time + 0.02;
      for (Series& s : plot.series) s.points.emplace_back(offset, std::nan(""));
    }
    figure.plots.push_back(plot);
  }
  page.figures.push_back(figure);
}

}  // namespace plumbline::bench
