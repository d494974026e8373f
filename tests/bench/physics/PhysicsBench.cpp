// How long a cycle of the physics takes, by the number of robots and in a heap, and how far replayed
// recordings end from the league's. Prints a table and writes build/bench/physics.json. One argument: seconds
// of CPU per figure (2).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <sstream>
#include <vector>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/MakeWorld.h"
#include "simulation/replay/Fidelity.h"
#include "simulation/replay/TraceReplay.h"

namespace plumbline::simulation {
namespace {

double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

simspark::LeagueTrace trace(const std::string& name) {
  return simspark::readLeagueTrace("tests/data/traces/" + name + ".csv.gz");
}

/// Robots that walk as recorded, side by side on the field.
class WalkingCrowd {
public:
  WalkingCrowd(int count, const std::string& engine) : world_(makeWorld(config(engine))) {
    for (int type = 0; type < 4; ++type) traces_.push_back(trace("ut_walk_replay_t" + std::to_string(type)));
    for (int i = 0; i < count; ++i) types_.push_back(count == 1 ? 0 : i % 4);
  }

  /// Mean CPU time of a cycle, commands included [s].
  double measure(double seconds) {
    double spent = 0;
    long cycles = 0;
    while (spent < seconds) {
      restart();
      for (std::size_t row = 0; row < 500 && spent < seconds; ++row, ++cycles) {
        const double before = cpuSeconds();
        for (std::size_t i = 0; i < types_.size(); ++i)
          for (const JointId joint : traces_[types_[i]].joints)
            world_->setJointVelocity(robots_[i], joint, traces_[types_[i]].rows[row].command[joint]);
        world_->step();
        spent += cpuSeconds() - before;
      }
    }
    return spent / static_cast<double>(cycles);
  }

private:
  static WorldConfig config(const std::string& engine) {
    WorldConfig config;
    config.engine = engine;
    return config;
  }

  void restart() {
    world_->reset();
    robots_.clear();
    for (std::size_t i = 0; i < types_.size(); ++i) {
      const simspark::TraceRow& first = traces_[types_[i]].rows[0];
      Pose3 place = first.torso;
      place.translation().head<2>() =
          Vec2(-14 + 14 * static_cast<double>(i % 2), -9.5 + 1.7 * static_cast<double>(i / 2));
      robots_.push_back(world_->addRobot(simsparkRobot(static_cast<int>(types_[i])), place));
      world_->setPosture(robots_.back(), first.axisAngle);
    }
  }

  std::unique_ptr<World> world_;
  std::vector<simspark::LeagueTrace> traces_;
  std::vector<std::size_t> types_;
  std::vector<RobotHandle> robots_;
};

/// Robots above each other, about to fall; their handles.
std::vector<RobotHandle> heapUp(World& world, int count) {
  std::vector<RobotHandle> robots;
  for (int i = 0; i < count; ++i)
    robots.push_back(
        world.addRobot(simsparkRobot(i % 5), translation(0.3 * (i % 2), 0.3 * (i / 2 % 2), 0.4 + 0.2 * i) *
                                                 rotation(Vec3(1, 2, 3).normalized(), 0.5 + i)));
  return robots;
}

/// They struggle, or they would fall asleep.
void struggle(World& world, const std::vector<RobotHandle>& robots, int cycle) {
  for (const RobotHandle robot : robots) {
    world.setJointVelocity(robot, lHipPitch, std::sin(0.1 * cycle + robot));
    world.setJointVelocity(robot, rShoulderPitch, std::cos(0.1 * cycle + robot));
  }
}

/// Robots that fall onto each other; every cycle's CPU time [s], sorted.
std::vector<double> heap(int count, const std::string& engine, int cycles) {
  WorldConfig config;
  config.engine = engine;
  const auto world = makeWorld(config);
  const std::vector<RobotHandle> robots = heapUp(*world, count);
  std::vector<double> times;
  for (int i = 0; i < cycles; ++i) {
    const double before = cpuSeconds();
    struggle(*world, robots, i);
    world->step();
    times.push_back(cpuSeconds() - before);
  }
  std::sort(times.begin(), times.end());
  return times;
}

/// How far a heap on the tree's solver gets from the same on ODE's own within so many cycles [m].
double heapDeviation(int count, int cycles) {
  WorldConfig config;
  const auto tree = makeWorld(config);
  config.engine = "ode-dense";
  const auto dense = makeWorld(config);
  double largest = 0;
  std::vector<RobotHandle> robots;
  for (World* world : {tree.get(), dense.get()}) robots = heapUp(*world, count);
  for (int i = 0; i < cycles; ++i) {
    for (World* world : {tree.get(), dense.get()}) {
      struggle(*world, robots, i);
      world->step();
    }
    for (const RobotHandle robot : robots)
      largest = std::max(
          largest, (tree->torso(robot).pose.translation() - dense->torso(robot).pose.translation()).norm());
  }
  return largest;
}

double resetSeconds() {
  const auto world = makeWorld();
  const RobotModel model = simsparkRobot(0);
  const double before = cpuSeconds();
  for (int i = 0; i < 20; ++i) {
    world->reset();
    for (int k = 0; k < 22; ++k) world->addRobot(model, translation(-14 + k, 0, 0.4));
  }
  return (cpuSeconds() - before) / 20;
}

/// Largest deviation over some recordings.
double worst(const std::vector<const char*>& names,
             const std::function<double(const TraceDeviation&)>& figure) {
  double largest = 0;
  for (const char* name : names) {
    const simspark::LeagueTrace league = trace(name);
    const auto ours = replayTrace(league, simsparkRobot(league.robotType.value_or(0)));
    largest = std::max(largest, figure(deviation(league.rows, ours)));
  }
  return largest;
}

class Report {
public:
  void add(const std::string& name, double value, const std::string& unit, double target, double peer = NAN,
           const std::string& peerName = "") {
    std::printf("%-46s %10.4f %-4s target %g", name.c_str(), value, unit.c_str(), target);
    if (!std::isnan(peer)) std::printf(", %s %g", peerName.c_str(), peer);
    std::printf("\n");
    json_ << (json_.tellp() > 0 ? ",\n " : "[") << "{\"name\":\"" << name << "\",\"value\":" << value
          << ",\"unit\":\"" << unit << "\",\"better\":\"lower\",\"target\":" << target;
    if (!std::isnan(peer)) json_ << ",\"peer\":\"" << peerName << "\",\"peer_value\":" << peer;
    json_ << "}";
  }
  bool write(const std::string& file) const {
    std::ofstream out(file);
    out << json_.str() << "]\n";
    return out.good();
  }

private:
  std::ostringstream json_;
};

}  // namespace
}  // namespace plumbline::simulation

int main(int argc, char** argv) {
  using namespace plumbline;
  using namespace plumbline::simulation;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 2;
  Report report;
  const std::string league = "league's whole server";
  report.add("simulator.physics.1_robot", 1e3 * WalkingCrowd(1, "ode").measure(seconds), "ms", 0.15, 0.36,
             league);
  report.add("simulator.physics.2_robots", 1e3 * WalkingCrowd(2, "ode").measure(seconds), "ms", 0.3, 0.84,
             league);
  report.add("simulator.physics.11_robots", 1e3 * WalkingCrowd(11, "ode").measure(seconds), "ms", 2, 6.7,
             league);
  report.add("simulator.physics.22_robots", 1e3 * WalkingCrowd(22, "ode").measure(seconds), "ms", 4, 16,
             league);
  const double dense = 1e3 * WalkingCrowd(1, "ode-dense").measure(seconds);
  report.add("simulator.physics.1_robot_dense", dense, "ms", 0.18);
  for (const int count : {1, 22})
    report.add("simulator.physics.bullet." + std::to_string(count) + (count == 1 ? "_robot" : "_robots"),
               1e3 * WalkingCrowd(count, "bullet").measure(seconds), "ms", count == 1 ? 0.1 : 4,
               count == 1 ? 0.36 : 16, league);
  for (const std::string engine : {"ode", "bullet"})
    for (const int count : {2, 4, 8, 22}) {
      const std::vector<double> times = heap(count, engine, 600);
      const double peer = count == 2 ? 1.8 : count == 4 ? 17 : count == 8 ? 143 : NAN;
      report.add("simulator.physics." + (engine == "ode" ? std::string() : engine + ".") + "heap_of_" +
                     std::to_string(count) + "_p95",
                 1e3 * times[times.size() * 95 / 100], "ms",
                 count > 8    ? 20
                 : count == 8 ? 10
                              : 2,
                 peer, "dense LCP");
    }
  report.add("simulator.physics.heap_of_4_tree_off_dense_after_6_s", 1e6 * heapDeviation(4, 300), "um", 1);
  report.add("simulator.physics.reset_22_robots", 1e3 * resetSeconds(), "ms", 10);

  const auto mm2s = [](const TraceDeviation& d) { return 1e3 * d.position2s; };
  const auto mm = [](const TraceDeviation& d) { return 1e3 * d.position; };
  report.add("simulator.fidelity.stand_crouch_fall",
             worst({"stand_t0", "stand_t1", "stand_t3", "stand_t4", "crouch_t0", "crouch_t1", "crouch_t3",
                    "crouch_t4", "fallF_t0", "fallF_t3", "fallB_t1", "fallB_t4", "swing_t0"},
                   mm),
             "mm", 1);
  const std::vector<const char*> walks = {"ut_walk_replay_t0", "ut_walk_replay_t1", "ut_walk_replay_t2",
                                          "ut_walk_replay_t3", "ut_walk_replay_t4", "ut_turn_t1",
                                          "ut_turn_t3"};
  report.add("simulator.fidelity.walk_turn_2s", worst(walks, mm2s), "mm", 2);
  report.add("simulator.fidelity.walk_turn_2s_rotation",
             worst(walks, [](const TraceDeviation& d) { return toDegrees(d.rotation2s); }), "deg", 0.2);
  report.add("simulator.fidelity.walk_turn_to_the_end", worst(walks, mm), "mm", 10, 944,
             "league's own replay");
  report.add("simulator.fidelity.get_up", worst({"ut_getup_t0", "ut_getup_t3"}, mm), "mm", 20);
  const auto ball = [](const TraceDeviation& d) { return 1e3 * d.ball; };
  report.add("simulator.fidelity.ball_roll_bounce",
             worst({"ball_roll_v1", "ball_roll_v3", "ball_roll_v6", "ball_roll_v10", "ball_lob_v6"}, ball),
             "mm", 1);
  report.add(
      "simulator.fidelity.ball_on_foot",
      worst({"ballfoot_v1_off0_t0", "ballfoot_v3_off0_t0", "ballfoot_v3_off0_t3", "ballfoot_v6_off0_t0"},
            ball),
      "mm", 10);
  report.add("simulator.fidelity.kick_ball", worst({"ut_kick_t3"}, ball), "mm", 50);
  std::system("mkdir -p build/bench");
  if (!report.write("build/bench/physics.json")) {
    std::fprintf(stderr, "build/bench/physics.json cannot be written\n");
    return 1;
  }
}
