#include <cmath>

#include "bench/walking/Steps.h"

namespace plumbline::bench {
namespace {

using namespace training;
using namespace walking;

/// Five minutes on the spot: table 4.3.
Observed onTheSpot(Walker& robot, const FittedWalk& fitted, Fit fit, double seconds) {
  robot.restart();
  fitted.give(robot.engine, fit);
  StepWatch watch(robot);
  int falls = 0;
  for (double time = 0; time < seconds; time += robot.cycle) {
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

void walkOnTheSpot(const Subject& subject, const BenchSetup& setup, Report& report, Page& page) {
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  const FittedWalk fitted = optimise(robot, [](double) { return WalkRequest{Vec2::Zero(), 0, true}; });
  std::array<double, fits.size()> bias{};
  Page::Figure figure{
      fmt::format("Figure 4.18, {}: the supporting foot at the end of each step on the spot.", subject.name),
      {}};
  for (const Fit fit : fits) {
    const Observed seen = onTheSpot(robot, fitted, fit, 30.0 * setup.seeds);
    std::vector<std::string> cells{subject.name, nameOf(fit)};
    append(cells, cellsOf(seen.figures));
    append(cells, {fmt::format("{:.1f}", seen.figures.footMean.norm()),
                   fmt::format("{:.1f}", seen.figures.footAbs), std::to_string(seen.falls)});
    report.row(cells);
    bias[static_cast<std::size_t>(fit)] = std::hypot(seen.figures.velocity.x(), seen.figures.velocity.y());
    Plot plot{
        .title = nameOf(fit), .xLabel = "x [mm]", .yLabel = "y [mm]", .series = {}, .equalScales = true};
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

void tableOnTheSpot(const std::vector<Subject>& subjects, const BenchSetup& setup, Report& report,
                    Page& page) {
  report.heading("Walking on the spot (table 4.3)");
  report.paragraph(
      "Five minutes, requested speed 0. The columns x to y' are the predicted state at the end of a step "
      "minus the observed one (mm, mm/s; y to the outside). The next ones are the change of the target "
      "within the step (mm), and the distance of the support foot from its place in the reference: of the "
      "mean, and mean over the steps (mm). Predicts: the model was optimised on 20 s of steps, twice, and "
      "tells the closed loop what the robot will do. Plans: a model that is safe for walking also plans the "
      "steps.");
  report.tableHead({"robot", "model", "x", "x'", "y", "y'", "change x", "change y", "foot mean",
                    "foot mean abs", "falls"});
  measureEach(subjects.size(), setup, report, page, [&](std::size_t i, Report& part, Page& figures) {
    walkOnTheSpot(subjects[i], setup, part, figures);
  });
}

void walkForwardBackward(const Subject& subject, const BenchSetup& setup, Report& report) {
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  const FittedWalk fitted = optimise(robot, forwardBackward);
  for (const Fit fit : fits) {
    robot.restart();
    fitted.give(robot.engine, fit);
    StepWatch watch(robot);
    std::vector<double> errors;
    double way = 0;
    int falls = 0;
    for (double time = 0; time < 30.0 * setup.seeds; time += robot.cycle) {
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
        if (phase + 1.5 * robot.cycle >= 3) errors.push_back(1000 * (way / 0.5 - 0.15));
      }
    }
    const Observed seen = watch.finish();
    const Estimate e = estimate(errors);
    double squares = 0;
    for (const double error : errors) squares += (error - e.mean) * (error - e.mean);
    std::vector<std::string> cells{subject.name, nameOf(fit)};
    append(cells, cellsOf(seen.figures));
    append(cells, {text(e, 1), fmt::format("{:.1f}", std::sqrt(squares / static_cast<double>(errors.size()))),
                   std::to_string(falls)});
    report.row(cells);
    report.figure(fmt::format("{}.switching_speed_error{}", subject.name,
                              fit == Fit::none         ? ""
                              : fit == Fit::prediction ? "_optimised"
                                                       : "_planned"),
                  std::abs(e.mean), "mm/s", {false, std::nan("")});
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
  measureEach(subjects.size(), setup, report,
              [&](std::size_t i, Report& part) { walkForwardBackward(subjects[i], setup, part); });
}

void tableImu(const std::vector<Subject>& subjects, Report& report) {
  report.heading("IMU against leg angles (table 4.1)");
  report.paragraph("Mean difference of the torso's pitch by the IMU and by the supporting legs (rad).");
  report.tableHead({"robot", "standing", "walking on the spot"});
  for (const Subject& subject : subjects) {
    const std::unique_ptr<Walker> walker = subject.walker();
    Walker& robot = *walker;
    std::vector<std::string> cells{subject.name};
    for (const bool walk : {false, true}) {
      robot.restart();
      double sum = 0;
      int count = 0;
      for (double time = 0; time < 20; time += robot.cycle) {
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
  Subject fitted;
  for (const Subject& subject : bench::subjects(setup.robots, true)) {
    // The league's types 0 and 3 stand for all.
    if (subject.name.starts_with("type") && subject.name[4] != '0' && subject.name[4] != '3') continue;
    subjects.push_back(subject);
    if (fitted.name.empty() || subject.name == "type0_plain") fitted = subject;
  }
  if (subjects.empty()) return;
  tableImu(subjects, report);
  tableOnTheSpot(subjects, setup, report, page);
  tableForwardBackward(subjects, setup, report);
  tableAcceleration(subjects, setup, report, page);
  figuresOfFit(fitted, page);
}

}  // namespace plumbline::bench
