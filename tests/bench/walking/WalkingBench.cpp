// How fast and how safely the league's robots walk in the simulator with the values in config/. Prints a
// table and writes build/bench/walking.json. One argument: minutes of random requests per type (15).
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <random>
#include <sstream>

#include "walking/WalkingRobot.h"

namespace plumbline::walking {
namespace {

struct Figures {
  double forward = 0, backward = 0, sideways = 0, turn = 0;  ///< [m/s, m/s, m/s, deg/s]
  double toHalfMetre = 0;                                    ///< from standing, time for 0.5 m forward [s]
  double straightFalls = 0;                                  ///< in the runs at full speed
  double fallsPerMinute = 0;                                 ///< with random requests
  double stops = 0;         ///< share of stops from full speed after which the robot stands within 2 s
  double ballFalls = 0;     ///< share of walks into a ball that end in a fall
  double odometry = 0;      ///< error of the told way with random requests, per metre
  double microseconds = 0;  ///< of the engine per cycle
};

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (random() / 4294967296.0);
}

WalkRequest randomRequest(std::mt19937& random, const WalkParameters& p) {
  WalkRequest request;
  request.walk = uniform(random, 0, 1) > 0.15;
  request.velocity =
      Vec2(uniform(random, -p.maxBackward, p.maxForward), uniform(random, -p.maxSideways, p.maxSideways));
  request.turn = uniform(random, -p.maxTurn, p.maxTurn);
  const double kind = uniform(random, 0, 4);
  if (kind < 1) {
    request.velocity = Vec2(p.maxForward, 0);
    request.turn *= 0.2;
  } else if (kind < 2) {
    request.velocity.setZero();
  }
  return request;
}

/// Mean speed along the request after two seconds; counts falls.
double fullSpeed(WalkingRobot& robot, const WalkRequest& request, double seconds, double& falls) {
  robot.restart(Pose2(-14, 5));  // clear of goals and walls for 30 m
  robot.run({}, 0.2);
  bool upright = robot.run(request, 2);
  const Vec2 direction =
      request.velocity.norm() > 0 ? request.velocity.normalized().eval() : Vec2(Vec2::Zero());
  double way = 0;
  const double before = robot.turned();
  for (long i = std::lround(seconds / 0.02); upright && i > 0; --i) {
    upright = robot.step(request);
    way += robot.moved.position.dot(direction);
  }
  falls += upright ? 0 : 1;
  return (request.turn != 0 ? std::abs(robot.turned() - before) : way) / seconds;
}

Figures measure(int type, double minutes) {
  Figures f;
  const WalkParameters p = readWalkParameters(type);
  WalkingRobot robot(type, p);
  const auto walk = [](double x, double y, double turn) { return WalkRequest{Vec2(x, y), turn, true}; };
  f.forward = fullSpeed(robot, walk(9, 0, 0), 25, f.straightFalls);
  f.backward = fullSpeed(robot, walk(-9, 0, 0), 10, f.straightFalls);
  f.sideways = (fullSpeed(robot, walk(0, 9, 0), 10, f.straightFalls) +
                fullSpeed(robot, walk(0, -9, 0), 10, f.straightFalls)) /
               2;
  f.turn = toDegrees(fullSpeed(robot, walk(0, 0, 9), 10, f.straightFalls) +
                     fullSpeed(robot, walk(0, 0, -9), 10, f.straightFalls)) /
           2;

  robot.restart();
  robot.run({}, 0.2);
  const Pose2 start = robot.pose();
  while (robot.step(walk(9, 0, 0)) && (start.inverse() * robot.pose()).x() < 0.5) f.toHalfMetre += 0.02;

  std::mt19937 random(1);
  constexpr int stops = 20, balls = 40;
  for (int i = 0; i < stops; ++i) {
    robot.restart();
    robot.run({}, uniform(random, 0, 0.4));
    robot.run(i < stops / 2 ? walk(9, 0, 0) : randomRequest(random, p), uniform(random, 1, 3));
    robot.run({}, 2);
    f.stops += robot.output.standing && !robot.local.fallen() ? 1.0 / stops : 0;
  }
  for (int i = 0; i < balls; ++i) {
    robot.restart();
    robot.local.world().setBall(Vec3(uniform(random, 0.3, 1), uniform(random, -0.12, 0.12), 0.042),
                                Vec3::Zero());
    f.ballFalls += robot.run(walk(9, 0, 0), 4) ? 0 : 1.0 / balls;
  }

  double falls = 0, way = 0, odometryError = 0;
  robot.restart();
  for (double time = 0; time < 60 * minutes;) {
    const WalkRequest request = randomRequest(random, p);
    const double duration = uniform(random, 0.3, 2);
    time += duration;
    Pose2 told, walked;
    bool upright = true;
    for (long i = std::lround(duration / 0.02); upright && i > 0; --i) {
      upright = robot.step(request);
      told = told * robot.output.odometry;
      walked = walked * robot.moved;
    }
    way += walked.position.norm();
    odometryError += (told.position - walked.position).norm();
    falls += upright ? 0 : 1;
    if (!upright || robot.pose().position.norm() > 8) robot.restart();
  }
  f.fallsPerMinute = falls / minutes;
  f.odometry = odometryError / way;

  WalkEngine engine(p, robot.model);
  WalkSensors sensors;
  constexpr int cycles = 5000;
  const std::clock_t begin = std::clock();
  for (int i = 0; i < cycles; ++i) sensors.angles = engine.update(walk(0.3, 0.1, 0.5), sensors).angles;
  f.microseconds = 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / cycles;
  return f;
}

class Report {
public:
  void add(int type, const char* what, double value, const char* unit, bool higher, double target,
           const char* peer = nullptr, double peerValue = 0) {
    json << (json.tellp() > 0 ? ",\n" : "[\n") << R"(  {"name": "walking.type)" << type << '.' << what
         << R"(", "value": )" << value << R"(, "unit": ")" << unit << R"(", "better": ")"
         << (higher ? "higher" : "lower") << R"(", "target": )" << target;
    if (peer) json << R"(, "peer": ")" << peer << R"(", "peer_value": )" << peerValue;
    json << '}';
  }
  bool write() {
    std::ofstream file("build/bench/walking.json");
    file << json.str() << "\n]\n";
    return static_cast<bool>(file);
  }

private:
  std::ostringstream json;
};

}  // namespace
}  // namespace plumbline::walking

int main(int argc, char** argv) {
  using namespace plumbline;
  using namespace plumbline::walking;
  const double minutes = argc > 1 ? std::atof(argv[1]) : 15;
  // Sustained forward speed of the better of two teams' published agents on the league's server.
  const double peer[numSimsparkTypes] = {0.83, 0.79, 0.87, 0.82, 0.85};
  Report report;
  std::printf(
      "| type | forward m/s | backward | sideways | turn deg/s | 0.5 m from stand s | falls straight | "
      "falls/min random | stops %% | ball falls %% | odometry error %% | us/cycle |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int type = 0; type < numSimsparkTypes; ++type) {
    const Figures f = measure(type, minutes);
    std::printf("| %d | %.2f | %.2f | %.2f | %.0f | %.2f | %.0f | %.2f | %.0f | %.0f | %.1f | %.1f |\n", type,
                f.forward, f.backward, f.sideways, f.turn, f.toHalfMetre, f.straightFalls, f.fallsPerMinute,
                100 * f.stops, 100 * f.ballFalls, 100 * f.odometry, f.microseconds);
    std::fflush(stdout);
    report.add(type, "forward", f.forward, "m/s", true, 0.5, "FC Portugal codebase 2024-10", peer[type]);
    report.add(type, "backward", f.backward, "m/s", true, 0.25);
    report.add(type, "sideways", f.sideways, "m/s", true, 0.25);
    report.add(type, "turn", f.turn, "deg/s", true, 80);
    report.add(type, "half_metre_from_stand", f.toHalfMetre, "s", false, 2.08);
    report.add(type, "falls_at_full_speed", f.straightFalls, "falls", false, 0);
    report.add(type, "falls_random", f.fallsPerMinute, "1/min", false, 0.2);
    report.add(type, "safe_stops", 100 * f.stops, "%", true, 100);
    report.add(type, "falls_over_ball", 100 * f.ballFalls, "%", false, 5);
    report.add(type, "odometry_error", 100 * f.odometry, "%", false, 10);
    report.add(type, "engine", f.microseconds, "us", false, 100);
  }
  return report.write() ? 0 : 1;
}
