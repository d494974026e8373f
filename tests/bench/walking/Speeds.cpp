#include <fmt/format.h>

#include "bench/walking/Sections.h"
#include "math/Random.h"
#include "training/WalkTrial.h"

namespace plumbline::bench {
namespace {

using namespace walking;
using namespace training;

constexpr double enough = 9;
constexpr int lanes = 40;  ///< 0.1 m apart, from the field's side to its goals

WalkRequest walk(double x, double y, double turn) { return {Vec2(x, y), turn, true}; }

void measure(const Subject& subject, const BenchSetup& setup, Report& report) {
  const std::unique_ptr<Walker> walker = subject.walker();
  Walker& robot = *walker;
  const WalkGaits& gaits = subject.gaits;
  std::vector<double> forward, backward, sideways, turn, half, falls, odometry, stops;
  int fallen = 0, runs = 0;
  const auto add = [&](std::vector<double>& to, WalkTrialKind task, double seconds, double wait, double sign,
                       int seed) {
    const HeldSpeed run = holdSpeed(robot, fullSpeed(task, sign), seconds, wait, 0.1 * (seed % lanes));
    to.push_back(task == WalkTrialKind::turn ? toDegrees(run.speed) : run.speed);
    fallen += run.upright ? 0 : 1;
    ++runs;
  };
  for (int seed = 0; seed < setup.seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(1000 + seed));
    const double wait = random.uniform(0.1, 0.6), sign = seed % 2 == 0 ? 1 : -1;
    add(forward, WalkTrialKind::forward, 60, wait, sign, seed);
    add(backward, WalkTrialKind::backward, 20, wait, sign, seed);
    add(sideways, WalkTrialKind::sideways, 20, wait, sign, seed);
    add(turn, WalkTrialKind::turn, 20, wait, sign, seed);

    robot.restart();
    robot.run({}, wait);
    const Pose2 start = robot.pose();
    double time = 0;
    while (robot.step(walk(enough, 0, 0)) && (start.inverse() * robot.pose()).x() < 0.5) time += robot.cycle;
    half.push_back(time);

    double safe = 0;
    for (int i = 0; i < 5; ++i) {
      robot.restart();
      robot.run({}, wait);
      const WalkParameters& p = gaits.base;
      robot.run(walk(random.uniform(-p.speed.maxBackward, enough),
                     random.uniform(-p.speed.maxSideways, p.speed.maxSideways),
                     random.uniform(-p.speed.maxTurn, p.speed.maxTurn)),
                random.uniform(1, 3));
      safe += robot.run({}, 2) && robot.output.standing ? 0.2 : 0;
    }
    stops.push_back(100 * safe);

    WalkTrialSetup trial;
    trial.seed = static_cast<std::uint64_t>(500 + seed);
    trial.tries = 1;
    trial.seconds = 60 * setup.minutes;
    trial.push = 0;
    trial.stopEarly = false;
    const WalkTrialResult mixture = tryWalk(robot, gaits, WalkTrialKind::mixture, trial);
    falls.push_back(mixture.falls);
    odometry.push_back(100 * mixture.odometry);
  }
  const auto mean = [](const std::vector<double>& v) { return estimate(v).mean; };
  report.row({subject.name, text(estimate(forward)), text(estimate(backward)), text(estimate(sideways)),
              text(estimate(turn), 0), text(estimate(half)), fmt::format("{} of {}", fallen, runs),
              text(estimate(falls)), text(estimate(stops), 0) + " %", text(estimate(odometry), 1) + " %"});
  const std::string name = subject.name + ".";
  report.figure(name + "forward", mean(forward), "m/s", {true, subject.forward}, subject.peer,
                subject.peerForward);
  report.figure(name + "backward", mean(backward), "m/s", {true, subject.backward});
  report.figure(name + "sideways", mean(sideways), "m/s", {true, subject.sideways});
  report.figure(name + "turn", mean(turn), "deg/s", {true, subject.turn});
  report.figure(name + "half_metre_from_stand", mean(half), "s", {false, 2.08});
  report.figure(name + "falls_at_full_speed", 100.0 * fallen / runs, "%", {false, 0});
  report.figure(name + "falls_random", mean(falls), "1/min", {false, 0.05});
  report.figure(name + "safe_stops", mean(stops), "%", {true, 100});
  report.figure(name + "odometry_error", mean(odometry), "%", {false, 10});
}

}  // namespace

void measureSpeeds(const BenchSetup& setup, Report& report) {
  report.heading("Speed and stability");
  report.paragraph(fmt::format(
      "Each cell: mean of {} runs and its 95 % interval. Forward: full speed for 60 s after the first 2 s; "
      "the other "
      "directions 20 s. Falls at full speed: share of all these runs. Random: any mixture of requests, "
      "changed every 0.3 to 2 s, {:.0f} minutes per run.",
      setup.seeds, setup.minutes));
  report.tableHead({"robot", "forward m/s", "backward m/s", "sideways m/s", "turn deg/s",
                    "0.5 m from stand s", "falls at full speed", "random: falls/min", "safe stops",
                    "odometry error"});
  const std::vector<Subject> robots = subjects(setup.robots, false);
  measureLong(
      robots.size(), setup, report,
      [&](std::size_t i) {
        return LongPart{robots[i], "speeds"};
      },
      [&](std::size_t i, Report& part) { measure(robots[i], setup, part); });
}

}  // namespace plumbline::bench
