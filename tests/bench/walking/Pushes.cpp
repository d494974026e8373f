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
using namespace training;

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

/// Pushes of 0.1 s on one robot, whatever it does.
class PushTest {
public:
  PushTest(Walker& robot, const WalkRequest& request) : robot_(robot), request_(request) {
    for (const Link& link : robot_.model.links) mass_ += link.mass;
  }

  /// The largest of the steps of 0.1 N s of which at least 95 % of the tries are survived. Halving with a
  /// fifth of them finds about where; all of them tell.
  double largest(const Vec2& direction, int tries) {
    const auto ok = [&](int steps, int count) { return mostSurvive(direction * (step * steps), count); };
    int good = 0, bad = 64;
    while (bad - good > 1) {
      const int middle = good == 0 && bad == 64 ? 8 : (good + bad) / 2;
      (ok(middle, std::max(20, tries / 5)) ? good : bad) = middle;
    }
    if (ok(good, tries)) {
      while (ok(good + 1, tries)) ++good;
    } else {
      while (good > 0 && !ok(good, tries)) --good;
    }
    return good * step;
  }

private:
  static constexpr double step = 0.1;  ///< [N s]

  /// Whether at least 95 % of the tries do.
  bool mostSurvive(const Vec2& momentum, int tries) {
    const int allowed = tries / 20;
    Random random(17);
    int falls = 0;
    for (int i = 0; i < tries && falls <= allowed; ++i)
      falls += survives(robot_, request_, momentum, mass_, random) ? 0 : 1;
    return falls <= allowed;
  }

  Walker& robot_;
  WalkRequest request_;
  double mass_ = 0;
};

}  // namespace

void measurePushes(const BenchSetup& setup, Report& report) {
  report.heading("Push recovery");
  report.paragraph(fmt::format(
      "The largest push in N s over 0.1 s after which the robot is still upright 3 s later in at least 95 % "
      "of {} tries. The push acts on the whole body, for the NAO at the torso. Walking: on the spot and "
      "forward at 0.3 m/s, the NAO at 0.15. Open loop: the same walk with all feedback at 0.",
      setup.tries));
  report.tableHead({"robot", "loop", "doing", directions[0], directions[1], directions[2], directions[3]});
  const std::vector<Subject> robots = embedded(subjects(setup.robots, false));
  constexpr std::size_t numDoings = 3;
  const auto name = [&](std::size_t i) {
    return LongPart{robots[i / (2 * numDoings)], fmt::format("pushes {}", i % (2 * numDoings))};
  };
  measureLong(robots.size() * 2 * numDoings, setup, report, name, [&](std::size_t i, Report& part) {
    const Subject& subject = robots[i / (2 * numDoings)];
    const bool open = i / numDoings % 2 == 0;
    const std::pair<const char*, WalkRequest> doings[numDoings] = {
        {"standing", {}},
        {"stepping", {Vec2(0, 0), 0, true}},
        {"walking", {Vec2(subject.walkingSpeed, 0), 0, true}}};
    const auto& [doing, request] = doings[i % numDoings];
    const std::unique_ptr<Walker> robot = subject.make(open ? withoutFeedback(subject.gaits) : subject.gaits);
    PushTest test(*robot, request);
    std::vector<std::string> cells{subject.name, open ? "open" : "closed", doing};
    double least = 1e9;
    for (const Vec2& direction : along) {
      const double push = test.largest(direction, setup.tries);
      least = std::min(least, push);
      cells.push_back(fmt::format("{:.1f}", push));
    }
    part.row(cells);
    part.figure(fmt::format("{}.push_{}_{}", subject.name, doing, open ? "open" : "closed"), least, "N s",
                {true, std::nan("")});
  });
}

}  // namespace plumbline::bench
