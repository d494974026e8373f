#include "TrainedGame.h"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace plumbline::bench {
namespace {

using namespace simspark;

constexpr double sceneSeconds = 0.1;
constexpr int restScenes = 20;                           // after the robots have beamed to their places
constexpr std::chrono::milliseconds betweenAgents{200};  // left are those who come first
constexpr double patience = 60;                          // for a scene [s of real time]
constexpr int mostScenes = 600;                          // until one is as wanted
constexpr const char* endlessHalf = "1000000";           // [s]

std::vector<std::string> simulatorOptions(std::uint64_t seed, std::size_t players) {
  return {"--sync",
          "--seed",
          std::to_string(seed),
          "--wait-agents",
          std::to_string(players),
          "--monitor-step",
          fmt::format("{}", sceneSeconds),
          "--half-time",
          endlessHalf,
          "--die-with-parent"};
}

}  // namespace

TrainedGame::TrainedGame(const std::string& programs, const std::string& scratch, std::uint64_t seed,
                         const TrainedTeam& left, const TrainedTeam& right)
    : scratch_(scratch),
      simulator_(programs + "/simulator", simulatorOptions(seed, left.types.size() + right.types.size()),
                 scratch + "/ports.json", scratch + "/simulator.log") {
  if (const std::string why = trainer_.connect("127.0.0.1", simulator_.ports().monitor); !why.empty())
    throw std::runtime_error(why);
  start(left);
  start(right);
  await("shows all robots", [&](const SceneState& scene) { return scene.robots.size() == agents_.size(); });
  if (scene().teamLeft != left.name)
    throw std::runtime_error("team " + right.name + " came first, and plays on the side of " + left.name);
}

TrainedGame::~TrainedGame() {
  for (auto& agent : agents_) agent->stop();
  trainer_.close();
  simulator_.process().stop();
}

void TrainedGame::start(const TrainedTeam& team) {
  for (std::size_t i = 0; i < team.types.size(); ++i) {
    std::vector<std::string> arguments = {team.programs + "/agent",
                                          "--team",
                                          team.name,
                                          "--number",
                                          std::to_string(static_cast<std::size_t>(team.firstNumber) + i),
                                          "--type",
                                          std::to_string(team.types[i]),
                                          "--port",
                                          std::to_string(simulator_.ports().agent),
                                          "--monitor-port",
                                          std::to_string(simulator_.ports().monitor),
                                          "--crash-log",
                                          scratch_ + "/crash.log"};
    arguments.insert(arguments.end(), team.options.begin(), team.options.end());
    agents_.push_back(
        std::make_unique<ChildProcess>(arguments, fmt::format("{}/agent{}.log", scratch_, agents_.size())));
    std::this_thread::sleep_for(betweenAgents);
  }
}

void TrainedGame::nextScene() {
  switch (trainer_.receive(patience)) {
    case Connection::Status::message:
      return;
    case Connection::Status::closed:
      throw std::runtime_error("the simulator is gone: " + trainer_.error());
    default:
      throw std::runtime_error("the simulator is silent; see " + scratch_);
  }
}

void TrainedGame::await(const char* what, const std::function<bool(const SceneState&)>& isSo) {
  for (int i = 0; i < mostScenes; ++i) {
    if (isSo(scene())) return;
    nextScene();
  }
  throw std::runtime_error(fmt::format("no scene {}; see {}", what, scratch_));
}

void TrainedGame::setMode(PlayMode mode) {
  send(PlayModeCommand{mode});
  await("has the play mode", [mode](const SceneState& now) { return now.playMode == playModeName(mode); });
}

void TrainedGame::begin() {
  for (std::size_t i = 0; i < agents_.size(); ++i)
    if (!agents_[i]->running())
      throw std::runtime_error(fmt::format("an agent ended; see {}/agent{}.log", scratch_, i));
  setMode(PlayMode::beforeKickOff);
  for (int i = 0; i < restScenes; ++i) nextScene();
}

}  // namespace plumbline::bench
