#include <cmath>

#include "bench/walking/Steps.h"
#include "math/Random.h"

namespace plumbline::bench {

using namespace training;
using namespace walking;

namespace {

void accelerate(const Subject& subject, Report& report, Page& page) {
  const Requests forward = [](double) { return WalkRequest{Vec2(0.2, 0), 0, true}; };
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  const double cycle = robot.cycle;
  const auto window = static_cast<std::size_t>(std::lround(0.2 / cycle));
  const FittedWalk fitted = optimise(robot, forward);
  Plot plot{.title = subject.name, .xLabel = "time [s]", .yLabel = "speed over 0.2 s [m/s]", .series = {}};
  for (const Fit fit : fits) {
    Random random(5);
    std::vector<double> totals, delays, accelerations, errors, deviations;
    StepWatch watch(robot);
    int fallen = 0;
    for (int run = 0; run < 30; ++run) {
      robot.putBack();
      fitted.give(robot.engine, fit);
      robot.run({}, random.uniform(0.3, 0.7));
      const Pose2 start = robot.pose();
      std::vector<double> way{0};
      double delay = 0, reached = 0;
      while (way.back() < 0.5 && cycle * static_cast<double>(way.size()) < 8) {
        if (!robot.step(forward(0))) break;
        watch.cycle();
        way.push_back((start.inverse() * robot.pose()).x());
        const double time = cycle * static_cast<double>(way.size() - 1);
        if (delay == 0 && way.back() > 0.005) delay = time;
        const std::size_t n = way.size();
        if (reached == 0 && n > window && way[n - 1] - way[n - 1 - window] > 0.9 * 0.2 * 0.2) reached = time;
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
      for (std::size_t i = window + 1; i < way.size(); ++i)
        if (cycle * static_cast<double>(i) > reached)
          speeds.push_back(1000 * ((way[i] - way[i - window]) / 0.2 - 0.2));
      const Estimate e = estimate(speeds);
      double squares = 0;
      for (const double speed : speeds) squares += (speed - e.mean) * (speed - e.mean);
      errors.push_back(e.mean);
      deviations.push_back(speeds.empty() ? 0 : std::sqrt(squares / static_cast<double>(speeds.size())));
      if (run == 0) {
        Series& series = plot.add(nameOf(fit));
        for (std::size_t i = window; i < way.size(); ++i)
          series.points.emplace_back(cycle * static_cast<double>(i), (way[i] - way[i - window]) / 0.2);
      }
    }
    const Observed seen = watch.finish();
    std::vector<std::string> cells{subject.name, nameOf(fit)};
    append(cells, cellsOf(seen.figures));
    cells.resize(6);  // this table has no change of the target
    append(cells, {text(estimate(totals), 0), text(estimate(delays), 0), text(estimate(accelerations), 2),
                   text(estimate(errors), 1), fmt::format("{:.1f}", estimate(deviations).mean),
                   std::to_string(fallen)});
    report.row(cells);
    if (fit != Fit::prediction) continue;
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

}  // namespace

void tableAcceleration(const std::vector<Subject>& subjects, const BenchSetup& setup, Report& report,
                       Page& page) {
  report.heading("From stand to 0.2 m/s (table 4.5)");
  report.paragraph(
      "Request 0.2 m/s from standing until 0.5 m are walked; 30 runs, between which what was learnt of the "
      "speed stays. Delay: until the torso is 5 mm ahead. "
      "Acceleration: until 90 % of 0.2 m/s are reached (mean over 0.2 s). Speed error: from then on.");
  report.tableHead({"robot", "model", "x", "x'", "y", "y'", "total time ms", "delay ms", "acc. m/s^2",
                    "speed error mean mm/s", "std. dev.", "falls"});
  measureEach(subjects.size(), setup, report, page,
              [&](std::size_t i, Report& part, Page& figures) { accelerate(subjects[i], part, figures); });
}

}  // namespace plumbline::bench
