#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/walking/Sections.h"
#include "math/Random.h"
#include "training/WalkTrial.h"
#include "training/WalkingRobot.h"

namespace plumbline::bench {
namespace {

using namespace walking;

constexpr const char* directions[] = {"from behind", "from the left", "from the front", "from the right"};
const Vec2 along[] = {Vec2(1, 0), Vec2(0, -1), Vec2(-1, 0), Vec2(0, 1)};

/// Whether the robot stays upright for three seconds after a push of this momentum over 0.1 s.
bool survives(Walker& robot, const WalkRequest& request, const Vec2& momentum, double mass, Random& random) {
  robot.restart();
  if (!robot.run({}, 0.3) || !robot.run(request, random.uniform(1.5, 2.2))) return false;
  const auto pushCycles = static_cast<int>(std::lround(0.1 / robot.cycle));
  const Vec2 change = Eigen::Rotation2Dd(robot.pose().heading) * momentum / mass / pushCycles;
  for (int i = 0; i < pushCycles; ++i) {
    robot.push(Vec3(change.x(), change.y(), 0));
    if (!robot.step(request)) return false;
  }
  return robot.run(request, 3);
}

/// The largest of the steps of 0.1 N s up to which at least 95 % of the tries are survived.
double largest(Walker& robot, const WalkRequest& request, const Vec2& direction, int tries) {
  double mass = 0;
  for (const Link& link : robot.model.links) mass += link.mass;
  constexpr double step = 0.1;  // [N s]
  const int allowed = tries / 20;
  const auto ok = [&](int steps) {
    Random random(17);
    int falls = 0;
    for (int i = 0; i < tries && falls <= allowed; ++i)
      falls += survives(robot, request, direction * (step * steps), mass, random) ? 0 : 1;
    return falls <= allowed;
  };
  int good = 0, bad = 64;
  while (bad - good > 1) {
    const int middle = good == 0 && bad == 64 ? 8 : (good + bad) / 2;
    (ok(middle) ? good : bad) = middle;
  }
  return good * step;
}

/// Tries of a robot whose world takes long.
int fewer(int tries) { return std::max(20, tries / 5); }

}  // namespace

void measurePushes(const BenchSetup& setup, Report& report) {
  report.heading("Push recovery");
  report.paragraph(fmt::format(
      "The largest push in N s over 0.1 s, acting on the whole body, after which the robot is "
      "still upright 3 s "
      "later in at least 95 % of {} tries, of the NAO {}, whose worlds are ten times slower. Walking: on the "
      "spot and forward at 0.3 m/s, the NAO at 0.15. "
      "The NAO is pushed at the torso. Open "
      "loop: the same walk with all feedback at 0.",
      setup.tries, fewer(setup.tries)));
  report.tableHead({"robot", "loop", "doing", directions[0], directions[1], directions[2], directions[3]});
  for (const Subject& subject : subjects(setup.robots, false)) {
    // The league's types 0 and 3 stand for all.
    if (subject.name.starts_with("type") && subject.name != "type0" && subject.name != "type3") continue;
    const WalkGaits& closed = subject.gaits;
    const int tries = subject.name.starts_with("nao") ? fewer(setup.tries) : setup.tries;
    for (const bool open : {true, false}) {
      const std::unique_ptr<Walker> walker = subject.make(open ? withoutFeedback(closed) : closed);
      Walker& robot = *walker;
      const std::pair<const char*, WalkRequest> doings[] = {
          {"standing", {}},
          {"stepping", {Vec2(0, 0), 0, true}},
          {"walking", {Vec2(subject.walkingSpeed, 0), 0, true}}};
      for (const auto& [doing, request] : doings) {
        std::vector<std::string> cells{subject.name, open ? "open" : "closed", doing};
        double least = 1e9;
        for (const Vec2& direction : along) {
          const double push = largest(robot, request, direction, tries);
          least = std::min(least, push);
          cells.push_back(fmt::format("{:.1f}", push));
        }
        report.row(cells);
        report.figure(fmt::format("{}.push_{}_{}", subject.name, doing, open ? "open" : "closed"), least,
                      "N s", {true, std::nan("")});
      }
    }
  }
}

}  // namespace plumbline::bench
