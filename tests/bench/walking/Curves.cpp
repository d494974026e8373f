#include <fmt/format.h>

#include "bench/walking/Sections.h"
#include "math/Random.h"
#include "training/Walker.h"

namespace plumbline::bench {
namespace {

using namespace walking;

struct Curve {
  double speed = 0, turn = 0;  ///< means forward [m/s], to the side asked for [rad/s]
  bool upright = true;
};

/// Four seconds straight, then 20 s with a turn, from another place and after another wait for each seed.
Curve walkCurve(Walker& robot, double forward, double turn, int seed) {
  constexpr double straight = 4, seconds = 20, bound = 9;
  Random random(static_cast<std::uint64_t>(3000 + seed));
  robot.restart(Pose2(0, 0.1 * seed));
  Curve curve;
  curve.upright = robot.run({}, random.uniform(0.1, 0.6)) && robot.run({Vec2(forward, 0), 0, true}, straight);
  const double before = robot.turned();
  double way = 0, time = 0;
  for (; curve.upright && time < seconds; time += robot.cycle) {
    curve.upright = robot.step({Vec2(forward, 0), turn, true});
    way += robot.moved.x();
    if (robot.pose().position.norm() > bound) robot.carry(Vec2(0, 0));
  }
  if (time > 0) curve.speed = way / time;
  if (time > 0) curve.turn = (robot.turned() - before) * (turn < 0 ? -1 : 1) / time;
  return curve;
}

void measure(const Subject& subject, const BenchSetup& setup, Report& report) {
  const std::unique_ptr<Walker> robot = subject.walker();
  const double full = subject.gaits.base.speed.maxForward;
  for (const double turn : {0.2, 0.4, 0.6}) {
    std::vector<double> speeds, turns;
    int fallen = 0;
    for (int seed = 0; seed < setup.seeds; ++seed) {
      for (const double sign : {1.0, -1.0}) {
        const Curve curve = walkCurve(*robot, full, sign * turn, seed);
        speeds.push_back(curve.speed);
        turns.push_back(curve.turn);
        fallen += curve.upright ? 0 : 1;
      }
    }
    report.row({subject.name, fmt::format("{:.1f}", turn), text(estimate(speeds)), text(estimate(turns)),
                fmt::format("{} of {}", fallen, speeds.size())});
  }
}

}  // namespace

void measureCurves(const BenchSetup& setup, Report& report) {
  std::vector<Subject> robots = embedded(subjects(setup.robots, false));
  std::erase_if(robots, [](const Subject& s) { return s.gaits.base.sprint.turnShare <= 0; });
  if (robots.empty()) return;
  report.heading("Turning at full speed");
  report.paragraph(fmt::format(
      "Full speed forward for 4 s, then with a turn for 20 s, to either side, from {} places. Robots whose "
      "sprints do not turn are left out. Each cell: mean and its 95 % interval.",
      setup.seeds));
  report.tableHead({"robot", "turn asked for rad/s", "forward m/s", "turn rad/s", "falls"});
  measureEach(robots.size(), setup, report,
              [&](std::size_t i, Report& part) { measure(robots[i], setup, part); });
}

}  // namespace plumbline::bench
