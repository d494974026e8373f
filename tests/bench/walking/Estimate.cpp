#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <optional>

#include "bench/walking/Sections.h"
#include "training/WalkingRobot.h"
#include "walking/estimation/VelocityFilter.h"
#include "walking/model/LinearInvertedPendulum.h"
#include "walking/planning/StepPlanner.h"

namespace plumbline::bench {
namespace {

using namespace walking;
using namespace training;

constexpr double cycle = 0.02;
using Style = Series::Style;

double processorMicroseconds() { return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Requests of all kinds in turn.
WalkRequest tour(double time, const WalkParameters& p) {
  const int part = static_cast<int>(time / 2.5) % 8;
  switch (part) {
    case 0:
      return {Vec2::Zero(), 0, true};
    case 1:
      return {Vec2(0.2, 0), 0, true};
    case 2:
      return {Vec2(p.speed.maxForward, 0), 0, true};
    case 3:
      return {Vec2(0, p.speed.maxSideways / 2), 0, true};
    case 4:
      return {Vec2(0.1, 0), p.speed.maxTurn / 2, true};
    case 5:
      return {Vec2(-p.speed.maxBackward, 0), 0, true};
    case 6:
      return {Vec2(0.15, -0.1), -p.speed.maxTurn / 3, true};
    default:
      return {};
  }
}

/// Error of the velocity estimate against the truth of the cycle that was measured.
void velocityError(const Subject& subject, Report& report) {
  const std::string& name = subject.name;
  const WalkGaits& gaits = subject.gaits;
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  const double cycle = robot.cycle;
  Vec2 squares = Vec2::Zero(), plain = Vec2::Zero();
  int count = 0;
  robot.restart();
  for (double time = 0; time < 200; time += cycle) {
    // The engine measures at the beginning of a cycle.
    const Vec2 truth = robot.comVelocity();
    if (!robot.step(tour(time, gaits.base))) robot.restart();
    if (time < 1) continue;
    squares += (robot.engine.observed().velocity - truth).cwiseAbs2();
    plain += (robot.engine.seenVelocity() - truth).cwiseAbs2();
    ++count;
  }
  const Vec2 rms = (squares / count).cwiseSqrt(), foot = (plain / count).cwiseSqrt();

  WalkEngine engine(gaits, robot.model);
  WalkSensors sensors;
  sensors.dt = cycle;
  constexpr int cycles = 5000;
  double begin = processorMicroseconds();
  for (int i = 0; i < cycles; ++i)
    sensors.angles = engine.update(tour(i * cycle, gaits.base), sensors).angles;
  const double whole = (processorMicroseconds() - begin) / cycles;
  const LinearInvertedPendulum model(0.25);
  VelocityFilter filter;
  WalkState state;
  state.support = Support::left;
  state.foot[0] = Pose2(0, 0.05);
  WalkAction action;
  action.duration = cycle;
  begin = processorMicroseconds();
  for (int i = 0; i < cycles; ++i)
    filter.update(model, state, action, cycle, {.change = {}, .seen = Vec2(0.1, 0.1)});
  const double filtering = (processorMicroseconds() - begin) / cycles;
  report.row({name, fmt::format("{:.3f}", rms.x()), fmt::format("{:.3f}", rms.y()),
              fmt::format("{:.3f}", foot.x()), fmt::format("{:.3f}", foot.y()),
              fmt::format("{:.1f}", filtering), fmt::format("{:.1f}", whole)});
  report.figure(name + ".velocity_rms_forward", rms.x(), "m/s", {false, 0.03});
  report.figure(name + ".velocity_rms_sideways", rms.y(), "m/s", {false, 0.03});
  report.figure(name + ".particle_filter", filtering, "us", {false, std::nan("")});
  report.figure(name + ".walking_thread", whole, "us", {false, 100});
}

void referenceFigure(Page& page) {
  const LinearInvertedPendulum model(0.25);
  const ReferenceTrajectory r =
      findReferenceTrajectory(model, {.velocity = Vec2(0.2, 0.2), .stepDuration = 0.25, .feetDistance = 0.1});
  Page::Figure figure{
      "Figure 4.2: reference trajectories at 0.2 m/s forward and to the left; the supporting foot relative "
      "to the centre of mass.",
      {}};
  for (const int axis : {0, 1}) {
    Plot plot{.title = axis == 0 ? "x" : "y",
              .xLabel = "time [s]",
              .yLabel = "foot [m], velocity [m/s]",
              .series = std::vector<Series>(2)};
    plot.series[0].name = "supporting foot";
    plot.series[1].name = "velocity";
    WalkState state = r.begin[0];
    for (int step = 0; step < 6; ++step) {
      const WalkAction& action = r.action[index(state.supportSide())];
      for (int i = 0; i <= 25; ++i) {
        const WalkState at = model.move(state, action, action.duration * i / 25);
        const double time = (step + i / 25.0) * action.duration;
        plot.series[0].points.emplace_back(time, at.supportFoot().position[axis]);
        plot.series[1].points.emplace_back(time, at.velocity[axis]);
      }
      plot.series[0].points.emplace_back(std::nan(""), 0);
      state = model.predict(state, action);
    }
    figure.plots.push_back(plot);
  }
  page.figures.push_back(figure);
}

/// A model that remembers what it was asked: planning uses it as a black box.
class WatchedModel : public WalkModel {
public:
  WalkState move(const WalkState& state, const WalkAction& action, double time) const override {
    const WalkState end = model_.move(state, action, time);
    if (time == action.duration && state.support == Support::right)
      asked.emplace_back(state.foot[1].position, end.velocity);
    return end;
  }
  mutable std::vector<std::pair<Vec2, Vec2>> asked;

private:
  LinearInvertedPendulum model_{0.25};
};

void searchFigure(Page& page) {
  const WatchedModel model;
  const Gait gait{.stepDuration = 0.25, .feetDistance = 0.1};
  const ReferenceTrajectory r = findReferenceTrajectory(model, gait);
  WalkState state = r.begin[0];
  state.velocity += Vec2(0.03, -0.02);
  model.asked.clear();
  StepPlanner(model, {}).step(state, 0, r);
  Plot targets{.title = "step targets visited", .xLabel = "x [m]", .yLabel = "y [m]", .series = {}};
  Plot velocities{
      .title = "velocities after the next step", .xLabel = "x [m/s]", .yLabel = "y [m/s]", .series = {}};
  Series& t = targets.add("visited, in order");
  Series& v = velocities.add("visited, in order");
  std::vector<Vec2> dots, ends;
  for (const auto& [target, velocity] : model.asked) {
    t.points.push_back(target);
    v.points.push_back(velocity);
  }
  dots = t.points;
  ends = v.points;
  targets.add("visited", Style::points).points = dots;
  velocities.add("visited", Style::points).points = ends;
  velocities.add("wanted", Style::points).points = {r.begin[0].velocity};
  page.figures.push_back(
      {fmt::format("Figure 4.3: the search for the step target, {} evaluations of the model.", dots.size()),
       {targets, velocities}});
}

/// A walk of 11 s: from standing forward, to the side, on the spot, stop; figures 4.5, 4.6, or
/// pushed, 4.9, 4.10.
void walkFigures(const WalkGaits& gaits, bool closed, Page& page) {
  WalkingRobot robot(0, closed ? gaits : withoutFeedback(gaits));
  const auto request = [&](double time) -> WalkRequest {
    if (time < 0.5 || time > 8) return {};
    if (closed) return {Vec2::Zero(), 0, true};
    return {time < 3 ? Vec2(0.2, 0) : time < 5.5 ? Vec2(0, 0.1) : Vec2(0, 0), 0, true};
  };
  Plot plots[2][2];
  const char* axes[] = {"x", "y"};
  for (int axis = 0; axis < 2; ++axis)
    for (int kind = 0; kind < 2; ++kind) {
      Plot& plot = plots[axis][kind];
      plot = {.title = fmt::format("{} of {}", axes[axis], kind == 0 ? "supporting foot" : "velocity"),
              .xLabel = "time [s]",
              .yLabel = kind == 0 ? "[m]" : "[m/s]",
              .series = std::vector<Series>(closed ? 3 : 2)};
      plot.series[0].name = "walk state";
      plot.series[1].name = "at the end of the step, predicted";
      plot.series[1].style = Style::points;
      if (closed) plot.series[2].name = "observed";
    }
  std::optional<Support> last;
  for (double time = 0; time < 11; time += cycle) {
    if (closed && time > 6 && time < 6.09) robot.push(Vec3(0, 0.035, 0));
    robot.step(request(time));
    const WalkState& state = robot.engine.state();
    const bool single = state.support != Support::both;
    const bool changed = last != state.support;
    last = state.support;
    WalkState end;
    if (single) {
      const WalkParameters p = robot.engine.gait();
      const LinearInvertedPendulum model(p.model.heights(), p.model.pressure(), robot.engine.prediction());
      WalkAction rest;
      rest.duration = robot.output.stepTime;
      end = model.move(state, rest, rest.duration);
    }
    for (int axis = 0; axis < 2; ++axis) {
      const double gap = std::nan("");
      if (changed)
        for (Plot* plot : {&plots[axis][0], &plots[axis][1]}) {
          plot->series[0].points.emplace_back(gap, 0);
          if (closed) plot->series[2].points.emplace_back(gap, 0);
        }
      if (!single) continue;
      plots[axis][0].series[0].points.emplace_back(time, state.supportFoot().position[axis]);
      plots[axis][1].series[0].points.emplace_back(time, state.velocity[axis]);
      plots[axis][0].series[1].points.emplace_back(time + robot.output.stepTime,
                                                   end.supportFoot().position[axis]);
      plots[axis][1].series[1].points.emplace_back(time + robot.output.stepTime, end.velocity[axis]);
      if (!closed || robot.engine.observed().support == Support::both) continue;
      plots[axis][0].series[2].points.emplace_back(time - 2 * cycle,
                                                   robot.engine.observed().supportFoot().position[axis]);
      plots[axis][1].series[2].points.emplace_back(time - 2 * cycle, robot.engine.observed().velocity[axis]);
    }
  }
  if (closed)
    page.figures.push_back(
        {"Figures 4.9 and 4.10: closed loop on the spot, pushed from the right at 6 s; the prediction for "
         "the end of each step drawn at that time.",
         {plots[1][0], plots[1][1], plots[0][0], plots[0][1]}});
  else
    page.figures.push_back(
        {"Figures 4.5 and 4.6: open loop, 0.2 m/s forward, 0.1 m/s to the left, on the spot, stop; the "
         "prediction for the end of each step is reached.",
         {plots[0][0], plots[0][1], plots[1][0], plots[1][1]}});
}

}  // namespace

void measureEstimate(const BenchSetup& setup, Report& report, Page& page) {
  report.heading("Velocity estimate and cost");
  report.paragraph(
      "Particle filter's velocity of the centre of mass against the simulator's, 200 s of all kinds of "
      "requests; "
      "beside it that of the supporting foot's movement alone. Cost on one core per cycle.");
  report.tableHead({"robot", "RMS x m/s", "RMS y m/s", "foot alone x", "foot alone y", "particle filter us",
                    "whole walk us"});
  for (const Subject& subject : embedded(subjects(setup.robots, true))) velocityError(subject, report);
  referenceFigure(page);
  searchFigure(page);
  walkFigures(plainWalk(), false, page);
  WalkGaits closed = plainWalk();
  closed.base.observation.positionGain = closed.base.observation.velocityGain = 0.05;
  for (WalkParameters& corner : closed.corner) corner = closed.base;
  walkFigures(closed, true, page);
}

}  // namespace plumbline::bench
