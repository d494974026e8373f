#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>

#include "bench/walking/Sections.h"
#include "math/Random.h"
#include "training/WalkingRobot.h"
#include "walking/BackgroundFit.h"

namespace plumbline::bench {
namespace {

using namespace walking;

constexpr double cycle = 0.02;

/// What tables 4.3 to 4.5 tell of steps, in mm and mm/s; y to the outside of the supporting foot.
struct StepFigures {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();  ///< predicted at the step's end minus observed
  Vec2 change = Vec2::Zero();                             ///< of the target within the step
  Vec2 footMean = Vec2::Zero();  ///< supporting foot at the step's end minus the reference's
  double footAbs = 0;
  int steps = 0;
};

struct Observed {
  StepFigures figures;
  int falls = 0;
  std::vector<Vec2> feet[2];  ///< supporting foot at the end of each step (figure 4.18)
  std::vector<Vec2> referenceFeet;
};

/// Follows a robot from step to step.
class StepWatch {
public:
  explicit StepWatch(WalkingRobot& robot) : robot(robot) {}

  void cycle() {
    const WalkOutput& out = robot.output;
    if (out.support != support) {
      if (support != Support::both && planned) {
        const double side = support == Support::left ? 1 : -1;
        result.figures.change += 1000 * Vec2(last.x() - planned->x(), -side * (last.y() - planned->y()));
      }
      support = out.support;
      planned.reset();
    } else if (support != Support::both) {
      last = out.stepTarget;
      if (!planned) planned = last;
    }
    if (const ObservedStep* step = robot.engine.observedStep()) add(*step);
  }
  /// The means.
  Observed finish() {
    StepFigures& f = result.figures;
    if (f.steps > 0) {
      const double n = f.steps;
      f.position /= n;
      f.velocity /= n;
      f.change /= n;
      f.footMean /= n;
      f.footAbs /= n;
    }
    return result;
  }
  std::function<void(const ObservedStep&)> onStep;

private:
  void add(const ObservedStep& step) {
    const Side side = step.begin.supportSide();
    const Vec2 outwards(1, outward(side));
    const auto& end = step.samples.back();
    const WalkState predicted = step.predicted(step.pendulum.with(robot.engine.modelParameters()), end.time);
    StepFigures& f = result.figures;
    f.position += 1000 * outwards.cwiseProduct(predicted.supportFoot().position - end.foot);
    f.velocity += 1000 * outwards.cwiseProduct(predicted.velocity - end.velocity);
    const ReferenceTrajectory& reference = robot.engine.reference();
    const Vec2 planned = reference.begin[index(other(side))].foot[index(side)].position;
    const Vec2 off = 1000 * outwards.cwiseProduct(end.foot - planned);
    f.footMean += off;
    f.footAbs += off.norm();
    ++f.steps;
    result.feet[index(side)].push_back(1000 * end.foot);
    if (result.referenceFeet.size() < 2) result.referenceFeet.push_back(1000 * planned);
    if (onStep) onStep(step);
  }

  WalkingRobot& robot;
  Observed result;
  Support support = Support::both;
  std::optional<Pose2> planned;
  Pose2 last;
};

/// A robot of a type that walks this gait, with or without a fit from walking before.
struct Subject {
  std::string name;
  int type;
  WalkGaits gaits;
};

std::vector<std::string> cellsOf(const StepFigures& f) {
  return {fmt::format("{:.1f}", f.position.x()), fmt::format("{:.1f}", f.velocity.x()),
          fmt::format("{:.1f}", f.position.y()), fmt::format("{:.1f}", f.velocity.y()),
          fmt::format("{:.2f}", f.change.x()),   fmt::format("{:.2f}", f.change.y())};
}

void append(std::vector<std::string>& cells, const std::vector<std::string>& more) {
  cells.insert(cells.end(), more.begin(), more.end());
}

using Requests = std::function<WalkRequest(double)>;

/// Walks as asked while the model is fitted to it, twice 20 s; the parameters that came of it.
ModelParameters optimise(WalkingRobot& robot, const Requests& requests, std::vector<double>* errors = nullptr,
                         std::vector<ObservedStep>* steps = nullptr) {
  robot.engine.setModelParameters({});
  robot.restart();
  BackgroundFit fit({.steps = 60, .maxSteps = 120, .duration = 20, .wait = true});
  int rounds = 0;
  for (double time = 0; rounds < 2 && time < 200; time += cycle) {
    if (!robot.step(requests(time))) robot.restart();
    if (const ObservedStep* step = robot.engine.observedStep()) {
      fit.add(*step);
      if (steps && rounds == 0 && steps->size() < 60) steps->push_back(*step);
    }
    if (const auto result = fit.pass(cycle, robot.engine.modelParameters())) {
      if (errors && rounds == 0) *errors = result->best;
      robot.engine.setModelParameters(result->parameters);
      ++rounds;
    }
  }
  return robot.engine.modelParameters();
}

/// Five minutes on the spot: table 4.3.
Observed onTheSpot(WalkingRobot& robot, const ModelParameters& fit, double seconds) {
  robot.restart();
  robot.engine.setModelParameters(fit);
  StepWatch watch(robot);
  int falls = 0;
  for (double time = 0; time < seconds; time += cycle) {
    if (!robot.step({Vec2::Zero(), 0, true})) {
      ++falls;
      robot.restart();
    }
    if (time > 3) watch.cycle();
  }
  Observed seen = watch.finish();
  seen.falls = falls;
  return seen;
}

WalkRequest forwardBackward(double time) { return {Vec2(std::fmod(time, 6) < 3 ? 0.15 : -0.15, 0), 0, true}; }

void tableOnTheSpot(const std::vector<Subject>& subjects, const BenchSetup& setup, Report& report,
                    Page& page) {
  report.heading("Walking on the spot (table 4.3)");
  report.paragraph(
      "Five minutes, requested speed 0. Predicted state at the end of a step minus the observed one (mm, "
      "mm/s; y "
      "to the outside), change of the target within the step (mm), distance of the supporting foot from its "
      "place in the reference: of the mean, and mean over the steps (mm). Second row: after the model was "
      "optimised on 20 s of steps, twice.");
  report.tableHead({"robot", "model", "x", "x'", "y", "y'", "change x", "change y", "foot mean",
                    "foot mean abs", "falls"});
  for (const Subject& subject : subjects) {
    WalkingRobot robot(subject.type, subject.gaits);
    const ModelParameters fit = optimise(robot, [](double) { return WalkRequest{Vec2::Zero(), 0, true}; });
    double bias[2] = {0, 0};
    Page::Figure figure{
        fmt::format("Figure 4.18, {}: the supporting foot at the end of each step on the spot.",
                    subject.name),
        {}};
    for (const bool optimised : {false, true}) {
      const Observed seen = onTheSpot(robot, optimised ? fit : ModelParameters{}, 30.0 * setup.seeds);
      std::vector<std::string> cells{subject.name, optimised ? "optimised" : "as it is"};
      append(cells, cellsOf(seen.figures));
      append(cells, {fmt::format("{:.1f}", seen.figures.footMean.norm()),
                     fmt::format("{:.1f}", seen.figures.footAbs), std::to_string(seen.falls)});
      report.row(cells);
      bias[optimised] = std::hypot(seen.figures.velocity.x(), seen.figures.velocity.y());
      Plot plot{.title = optimised ? "with optimised model" : "without optimisation",
                .xLabel = "x [mm]",
                .yLabel = "y [mm]",
                .series = {},
                .equalScales = true};
      plot.add("left", Series::Style::points).points = seen.feet[0];
      plot.add("right", Series::Style::points).points = seen.feet[1];
      plot.add("reference", Series::Style::points).points = seen.referenceFeet;
      figure.plots.push_back(plot);
    }
    page.figures.push_back(figure);
    report.figure(fmt::format("{}.spot_velocity_bias", subject.name), bias[0], "mm/s", {false, std::nan("")});
    report.figure(fmt::format("{}.spot_velocity_bias_optimised", subject.name), bias[1], "mm/s",
                  {false, std::max(5.0, bias[0] / 2)});
  }
}

void tableForwardBackward(const std::vector<Subject>& subjects, const BenchSetup& setup, Report& report) {
  report.heading("Forward and backward (table 4.4)");
  report.paragraph(
      "Request 0.15 m/s forward and backward, changed every 3 s. Walk speed error: true mean speed of the "
      "last "
      "0.5 s before each change, along the request, minus 0.15 m/s: mean and deviation (mm/s).");
  report.tableHead({"robot", "model", "x", "x'", "y", "y'", "change x", "change y", "speed error mean",
                    "std. dev.", "falls"});
  for (const Subject& subject : subjects) {
    WalkingRobot robot(subject.type, subject.gaits);
    const ModelParameters fit = optimise(robot, forwardBackward);
    for (const bool optimised : {false, true}) {
      robot.restart();
      robot.engine.setModelParameters(optimised ? fit : ModelParameters{});
      StepWatch watch(robot);
      std::vector<double> errors;
      double way = 0;
      int falls = 0;
      for (double time = 0; time < 30.0 * setup.seeds; time += cycle) {
        const WalkRequest request = forwardBackward(time);
        if (!robot.step(request)) {
          ++falls;
          robot.restart();
        }
        watch.cycle();
        const double phase = std::fmod(time, 3);
        if (phase < 2.5) {
          way = 0;
        } else {
          way += robot.moved.position.x() * (request.velocity.x() > 0 ? 1 : -1);
          if (phase + 1.5 * cycle >= 3) errors.push_back(1000 * (way / 0.5 - 0.15));
        }
      }
      const Observed seen = watch.finish();
      const Estimate e = estimate(errors);
      double squares = 0;
      for (const double error : errors) squares += (error - e.mean) * (error - e.mean);
      std::vector<std::string> cells{subject.name, optimised ? "optimised" : "as it is"};
      append(cells, cellsOf(seen.figures));
      append(cells,
             {text(e, 1), fmt::format("{:.1f}", std::sqrt(squares / static_cast<double>(errors.size()))),
              std::to_string(falls)});
      report.row(cells);
      report.figure(fmt::format("{}.switching_speed_error{}", subject.name, optimised ? "_optimised" : ""),
                    std::abs(e.mean), "mm/s", {false, std::nan("")});
    }
  }
}

void tableAcceleration(const std::vector<Subject>& subjects, Report& report, Page& page) {
  report.heading("From stand to 0.2 m/s (table 4.5)");
  report.paragraph(
      "Request 0.2 m/s from standing until 0.5 m are walked; 30 runs. Delay: until the torso is 5 mm ahead. "
      "Acceleration: until 90 % of 0.2 m/s are reached (mean over 0.2 s). Speed error: from then on.");
  report.tableHead({"robot", "model", "x", "x'", "y", "y'", "total time ms", "delay ms", "acc. m/s^2",
                    "speed error mean mm/s", "std. dev.", "falls"});
  const Requests forward = [](double) { return WalkRequest{Vec2(0.2, 0), 0, true}; };
  for (const Subject& subject : subjects) {
    WalkingRobot robot(subject.type, subject.gaits);
    const ModelParameters fit = optimise(robot, forward);
    Plot plot{.title = subject.name, .xLabel = "time [s]", .yLabel = "speed over 0.2 s [m/s]", .series = {}};
    for (const bool optimised : {false, true}) {
      Random random(5);
      std::vector<double> totals, delays, accelerations, errors, deviations;
      StepWatch watch(robot);
      int fallen = 0;
      for (int run = 0; run < 30; ++run) {
        robot.restart();
        robot.engine.setModelParameters(optimised ? fit : ModelParameters{});
        robot.run({}, random.uniform(0.3, 0.7));
        const Pose2 start = robot.pose();
        std::vector<double> way{0};
        double delay = 0, reached = 0;
        while (way.back() < 0.5 && way.size() < 400) {
          if (!robot.step(forward(0))) break;
          watch.cycle();
          way.push_back((start.inverse() * robot.pose()).x());
          const double time = cycle * static_cast<double>(way.size() - 1);
          if (delay == 0 && way.back() > 0.005) delay = time;
          const std::size_t n = way.size();
          if (reached == 0 && n > 10 && way[n - 1] - way[n - 11] > 0.9 * 0.2 * 0.2) reached = time;
        }
        if (way.back() < 0.5) {
          ++fallen;
          continue;
        }
        const double total = cycle * static_cast<double>(way.size() - 1);
        totals.push_back(1000 * total);
        delays.push_back(1000 * delay);
        if (reached > delay) accelerations.push_back(0.18 / (reached - delay));
        std::vector<double> speeds;
        for (std::size_t i = 11; i < way.size(); ++i)
          if (cycle * static_cast<double>(i) > reached)
            speeds.push_back(1000 * ((way[i] - way[i - 10]) / 0.2 - 0.2));
        const Estimate e = estimate(speeds);
        double squares = 0;
        for (const double speed : speeds) squares += (speed - e.mean) * (speed - e.mean);
        errors.push_back(e.mean);
        deviations.push_back(speeds.empty() ? 0 : std::sqrt(squares / static_cast<double>(speeds.size())));
        if (run == 0) {
          Series& series = plot.add(optimised ? "optimised model" : "as it is");
          for (std::size_t i = 10; i < way.size(); ++i)
            series.points.emplace_back(cycle * static_cast<double>(i), (way[i] - way[i - 10]) / 0.2);
        }
      }
      const Observed seen = watch.finish();
      std::vector<std::string> cells{subject.name, optimised ? "optimised" : "as it is"};
      append(cells, cellsOf(seen.figures));
      cells.resize(6);  // this table has no change of the target
      append(cells, {text(estimate(totals), 0), text(estimate(delays), 0), text(estimate(accelerations), 2),
                     text(estimate(errors), 1), fmt::format("{:.1f}", estimate(deviations).mean),
                     std::to_string(fallen)});
      report.row(cells);
      if (!optimised) continue;
      report.figure(subject.name + ".acceleration_total", estimate(totals).mean, "ms", {false, 2080},
                    "thesis, SimSpark type 0, optimised", 2082);
      report.figure(subject.name + ".acceleration_delay", estimate(delays).mean, "ms", {false, 300},
                    "thesis, SimSpark type 0, optimised", 301);
      report.figure(subject.name + ".acceleration_speed_error", std::abs(estimate(errors).mean), "mm/s",
                    {false, 14.6}, "thesis, SimSpark type 0, optimised", 14.6);
    }
    page.figures.push_back(
        {fmt::format("Figure 4.24, {}: speed from standing at a request of 0.2 m/s.", subject.name), {plot}});
  }
}

void figuresOfFit(const Subject& subject, Page& page) {
  WalkingRobot robot(subject.type, subject.gaits);
  std::vector<double> errors;
  std::vector<ObservedStep> steps;
  const ModelParameters fit = optimise(robot, forwardBackward, &errors, &steps);
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

void tableImu(const std::vector<Subject>& subjects, Report& report) {
  report.heading("IMU against leg angles (table 4.1)");
  report.paragraph("Mean difference of the torso's pitch by the IMU and by the supporting legs (rad).");
  report.tableHead({"robot", "standing", "walking on the spot"});
  for (const Subject& subject : subjects) {
    WalkingRobot robot(subject.type, subject.gaits);
    std::vector<std::string> cells{subject.name};
    for (const bool walk : {false, true}) {
      robot.restart();
      double sum = 0;
      int count = 0;
      for (double time = 0; time < 20; time += cycle) {
        robot.step({Vec2::Zero(), 0, walk});
        if (time < 5) continue;
        sum += robot.engine.imuDifference().y();
        ++count;
      }
      cells.push_back(fmt::format("{:.4f}", sum / count));
    }
    report.row(cells);
  }
}

}  // namespace

void measureThesisTables(const BenchSetup& setup, Report& report, Page& page) {
  std::vector<Subject> subjects;
  for (const int type : {0, 3}) {
    subjects.push_back({fmt::format("type{}", type), type, readWalkGaits(type)});
    subjects.push_back({fmt::format("type{}_plain", type), type, plainWalk()});
  }
  tableImu(subjects, report);
  tableOnTheSpot(subjects, setup, report, page);
  tableForwardBackward(subjects, setup, report);
  tableAcceleration(subjects, report, page);
  figuresOfFit(subjects[1], page);
}

}  // namespace plumbline::bench
