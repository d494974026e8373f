// Recordings of this simulator itself, repeated: by the same physics they come out alike.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "math/Angle.h"
#include "simspark/LeagueRecording.h"
#include "simspark/LeagueRobots.h"
#include "simulation/Simulation.h"
#include "simulation/replay/Fidelity.h"
#include "simulation/replay/Placement.h"
#include "simulation/replay/ReplayReport.h"
#include "simulation/replay/TraceReplay.h"
#include "simulation/replay/TraceRowOf.h"
#include "support/TraceWriter.h"

namespace plumbline::simulation {
namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;

/// A game without noise in which what was commanded and what came of it is written down.
class Recorder {
public:
  explicit Recorder(const std::vector<int>& types) : simulation_(silent()) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      ids_.push_back(simulation_.addPlayer(types[i]));
      simspark::AgentCommand command;
      command.init = simspark::InitRequest{static_cast<int>(i) + 1, "team"};
      EXPECT_EQ(simulation_.act(ids_.back(), command), "");
    }
    commands_.resize(types.size());
    pending_.resize(types.size());
    inForce_.resize(types.size());
    rows_.resize(types.size());
  }

  void command(std::size_t robot, JointId joint, double speed) { commands_[robot].velocity[joint] = speed; }
  void beam(std::size_t robot, const Pose2& place) { commands_[robot].beam = place; }
  /// Sends what was commanded since the last step, which acts in the step after this one, and makes a row.
  void step(bool record = true) {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      for (std::size_t j = 0; j < numHumanoidJoints; ++j)
        if (commands_[i].velocity[j]) inForce_[i][j] = *commands_[i].velocity[j];
      if (!rows_[i].empty()) rows_[i].back().command = inForce_[i];
      EXPECT_EQ(simulation_.act(ids_[i], pending_[i]), "");
    }
    simulation_.step();
    pending_ = std::exchange(commands_, std::vector<simspark::AgentCommand>(ids_.size()));
    for (std::size_t i = 0; record && i < ids_.size(); ++i) {
      const Player& player = *simulation_.allPlayers().at(ids_[i]);
      rows_[i].push_back(traceRowOf(simulation_.world(), player.robot, player.model().linkIndex("lFoot"),
                                    player.model().linkIndex("rFoot"), inForce_[i]));
    }
  }

  const std::vector<TraceRow>& of(std::size_t robot) const { return rows_[robot]; }

private:
  static SimulationConfig silent() {
    SimulationConfig config;
    config.players.beamNoise = config.players.beamTurnNoise = 0;
    config.rules.moves.startAnywhere = true;
    return config;
  }

  Simulation simulation_;
  std::vector<PlayerId> ids_;
  std::vector<simspark::AgentCommand> commands_, pending_;
  std::vector<JointArray> inForce_;
  std::vector<std::vector<TraceRow>> rows_;
};

std::vector<JointId> jointsOf(const RobotModel& model) {
  std::vector<JointId> joints;
  for (int j = 0; j < numHumanoidJoints; ++j)
    if (model.has(static_cast<JointId>(j))) joints.push_back(static_cast<JointId>(j));
  return joints;
}

/// The folder of a recording of two robots: they stand face to face with their forearms beside each other's.
/// The first pushes an arm of the other aside and takes its own back; both nod.
std::filesystem::path twoRobots(const std::string& name, bool beamed) {
  Recorder game({0, 0});
  game.beam(0, Pose2(-0.9, 0.6, 0));
  game.beam(1, Pose2(-0.6, 0.67, pi));
  game.command(0, headYaw, 1e-7);
  game.command(1, headYaw, 1e-7);
  for (int i = 0; i < 100; ++i) game.step(false);
  for (int i = 0; i < 250; ++i) {
    const double speed = 0.4 * std::sin(2 * pi * i / 100);
    for (std::size_t robot = 0; robot < 2; ++robot) game.command(robot, headPitch, speed);
    game.command(0, lShoulderRoll, speed);
    if (beamed && i == 120) game.beam(1, Pose2(0.4, 0.5, 0.7));
    if (beamed && i == 130) game.beam(0, Pose2(-0.9, 0.8, 0.1));
    game.step();
  }
  const std::filesystem::path folder = testing::TempDir() + "several_" + name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  plumbline::test::writeTrace(folder / (name + "_r1t0.csv"), jointsOf(simsparkRobot(0)), game.of(0));
  plumbline::test::writeTrace(folder / (name + "_r2t0.csv"), jointsOf(simsparkRobot(0)), game.of(1));
  return folder;
}

void expectRepeated(const std::filesystem::path& folder, std::vector<std::size_t> placed) {
  const auto traces =
      simspark::readLeagueRecording(folder / (folder.filename().string().substr(8) + "_r2t0.csv"));
  ASSERT_EQ(traces.size(), 2u);
  const auto ours = replayTraces(traces, {simsparkRobot(0), simsparkRobot(0)});
  for (std::size_t r = 0; r < 2; ++r) {
    const TraceDeviation off = deviation(traces[r].rows, ours[r]);
    EXPECT_LT(off.position, 2e-4) << traces[r].name;
    EXPECT_LT(toDegrees(off.rotation), 0.02) << traces[r].name;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < traces[r].rows.size(); ++i)
      if (isPlaced(traces[r], i)) found.push_back(i);
    const bool expected = r < placed.size() && placed[r] > 0;
    EXPECT_EQ(found, expected ? std::vector{placed[r]} : std::vector<std::size_t>{}) << traces[r].name;
  }
}

TEST(SeveralRobots, areRepeatedInOneWorld) { expectRepeated(twoRobots("arms", false), {}); }

TEST(SeveralRobots, areBeamedWhereTheyWereBeamed) { expectRepeated(twoRobots("beams", true), {131, 121}); }

TEST(SeveralRobots, touchEachOther) {
  const auto folder = twoRobots("alone", false);
  const LeagueTrace one = simspark::readLeagueTrace(folder / "alone_r1t0.csv");
  EXPECT_GT(deviation(one.rows, replayTrace(one, simsparkRobot(0))).position, 1e-3)
      << "without the other one it is no test";
}

TEST(SeveralRobots, needAModelEachAndAsManyRows) {
  auto traces = simspark::readLeagueRecording(twoRobots("rows", false) / "rows_r1t0.csv");
  EXPECT_THROW(replayTraces(traces, {simsparkRobot(0)}), std::invalid_argument);
  traces[1].rows.pop_back();
  EXPECT_THROW(replayTraces(traces, {simsparkRobot(0), simsparkRobot(0)}), std::invalid_argument);
}

/// No robot of the league's recordings was put anywhere while it was recorded.
TEST(Placement, isSeenNowhereInTheLeaguesRecordings) {
  for (const auto& entry : std::filesystem::directory_iterator("tests/data/traces")) {
    if (!entry.is_regular_file() || !entry.path().string().ends_with(".csv.gz")) continue;
    const LeagueTrace trace = simspark::readLeagueTrace(entry.path());
    for (std::size_t i = 0; i < trace.rows.size(); ++i)
      EXPECT_FALSE(isPlaced(trace, i)) << trace.name << " row " << i;
  }
}

TEST(SeveralRobots, haveAReportEach) {
  const std::string text = replayReport(twoRobots("report", true) / "report_r1t0.csv", {});
  EXPECT_NE(text.find("report_r1t0, robot type 0, 250 rows\n"), std::string::npos) << text;
  EXPECT_NE(text.find("report_r2t0, robot type 0, 250 rows\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("by 1 cm from row 1"), std::string::npos) << text;
}

}  // namespace
}  // namespace plumbline::simulation
