#include "Duel.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>

#include "field/FieldSize.h"
#include "math/Angle.h"
#include "math/Random.h"
#include "watch/GameCounter.h"

namespace plumbline::bench {
namespace {

using namespace simspark;

constexpr std::array types = {4, 3, 2};  // of a team's robots, numbers 2 to 4: there is no goalie
constexpr int firstNumber = 2;
constexpr const char* attack = "Attack";  // the left team's name
constexpr double sceneSeconds = 0.1;
constexpr int restScenes = 20;                           // after the robots have beamed to their places
constexpr std::chrono::milliseconds betweenAgents{200};  // left are those who come first
constexpr double patience = 60;                          // for a scene [s of real time]
constexpr int mostScenes = 600;                          // until one is as wanted
constexpr const char* endlessHalf = "1000000";           // [s]
const double halfLength = FieldSize().length / 2;        // [m]
constexpr double nearest = 1, farthest = 6, aside = 4;   // the ball's place before the goal [m]
constexpr double robotHeight = 0.4;                      // of a torso that is put upright [m]
constexpr double apart = 0.4;                            // of robots that are put [m]
constexpr double faces = 0.5;                            // how far from the ball at most [rad]

/// Where a robot may be put around the ball.
struct Sector {
  double least, most;    // distance [m]
  double middle, width;  // direction, to either side [rad]
};

/// Draws places that keep apart from each other and stay before the goal line.
class Places {
public:
  explicit Places(std::uint64_t seed) : random_(seed) {
    ball = Vec2(halfLength - random_.uniform(nearest, farthest), random_.uniform(-aside, aside));
  }

  MoveAgentCommand put(PlayerName player, const Sector& sector) {
    constexpr int tries = 100;
    Vec2 spot;
    for (int i = 0; i < tries; ++i) {
      const double angle = sector.middle + random_.uniform(-sector.width, sector.width);
      spot = ball + random_.uniform(sector.least, sector.most) * Vec2(std::cos(angle), std::sin(angle));
      if (spot.x() < halfLength - apart && isFree(spot)) break;
    }
    taken_.push_back(spot);
    const Vec2 way = ball - spot;
    return {.player = player,
            .position = Vec3(spot.x(), spot.y(), robotHeight),
            .heading = std::atan2(way.y(), way.x()) + random_.uniform(-faces, faces)};
  }

  Vec2 ball;

private:
  bool isFree(const Vec2& spot) const {
    return std::ranges::all_of(taken_, [&](const Vec2& other) { return (other - spot).norm() > apart; });
  }

  Random random_;
  std::vector<Vec2> taken_;
};

/// What happens in a duel, scene by scene.
class Watch {
public:
  void observe(const SceneState& scene) {
    counter_.observe(scene);
    const SceneRobot* first = nullptr;
    double least = 0;
    for (const SceneRobot& robot : scene.robots) {
      const Vec3 torso = robot.T_world_torso.translation();
      const double distance = (torso - scene.ball).head<2>().norm();
      if (!first || distance < least) {
        first = &robot;
        least = distance;
      }
    }
    ++scenes_;
    if (first && first->side == TeamSide::left) ++nearest_;
  }
  void tell(DuelResult& result) const {
    result.nearest = scenes_ > 0 ? static_cast<double>(nearest_) / scenes_ : 0;
    result.falls = counter_.falls(TeamSide::left);
    result.charging = counter_.fouls(TeamSide::left, FoulKind::charging);
    result.touching = counter_.fouls(TeamSide::left, FoulKind::touching);
  }

private:
  watch::GameCounter counter_;
  int scenes_ = 0, nearest_ = 0;  ///< all, and those in which an attacker is nearest to the ball
};

std::vector<std::string> simulatorOptions(std::uint64_t seed) {
  return {"--sync",
          "--seed",
          std::to_string(seed),
          "--wait-agents",
          std::to_string(2 * types.size()),
          "--monitor-step",
          fmt::format("{}", sceneSeconds),
          "--half-time",
          endlessHalf,
          "--die-with-parent"};
}

bool isPlayedOn(const std::string& mode) {
  return mode == playModeName(PlayMode::playOn) || mode.starts_with("pass");
}

}  // namespace

Duel::Duel(const DuelOptions& options, std::uint64_t seed)
    : options_(options),
      simulator_(options.programs + "/simulator", simulatorOptions(seed), options.scratch + "/ports.json",
                 options.scratch + "/simulator.log") {
  if (const std::string why = trainer_.connect("127.0.0.1", simulator_.ports().monitor); !why.empty())
    throw std::runtime_error(why);
  startAgents();
  await("shows all robots", [&](const SceneState& scene) { return scene.robots.size() == agents_.size(); });
  if (trainer_.scene().teamLeft != attack)
    throw std::runtime_error("the defenders came first, and play on the attackers' side");
}

Duel::~Duel() {
  for (auto& agent : agents_) agent->stop();
  trainer_.close();
  simulator_.process().stop();
}

void Duel::startAgents() {
  for (const bool attacks : {true, false})
    for (std::size_t i = 0; i < types.size(); ++i) {
      std::vector<std::string> arguments = {(attacks ? options_.attackers : options_.programs) + "/agent",
                                            "--team",
                                            attacks ? attack : "Defence",
                                            "--number",
                                            std::to_string(firstNumber + i),
                                            "--type",
                                            std::to_string(types[i]),
                                            "--port",
                                            std::to_string(simulator_.ports().agent),
                                            "--monitor-port",
                                            std::to_string(simulator_.ports().monitor),
                                            "--crash-log",
                                            options_.scratch + "/crash.log"};
      if (!attacks) arguments.insert(arguments.end(), {"--modules", options_.defence});
      agents_.push_back(std::make_unique<ChildProcess>(
          arguments, fmt::format("{}/agent{}.log", options_.scratch, agents_.size())));
      std::this_thread::sleep_for(betweenAgents);
    }
}

void Duel::nextScene() {
  switch (trainer_.receive(patience)) {
    case Connection::Status::message:
      return;
    case Connection::Status::closed:
      throw std::runtime_error("the simulator is gone: " + trainer_.error());
    default:
      throw std::runtime_error("the simulator is silent; see " + options_.scratch);
  }
}

void Duel::await(const char* what, const std::function<bool(const SceneState&)>& isSo) {
  for (int i = 0; i < mostScenes; ++i) {
    if (isSo(trainer_.scene())) return;
    nextScene();
  }
  throw std::runtime_error(fmt::format("no scene {}; see {}", what, options_.scratch));
}

void Duel::setMode(PlayMode mode) {
  trainer_.send(PlayModeCommand{mode});
  await("has the play mode",
        [mode](const SceneState& scene) { return scene.playMode == playModeName(mode); });
}

void Duel::checkAgents() {
  for (std::size_t i = 0; i < agents_.size(); ++i)
    if (!agents_[i]->running())
      throw std::runtime_error(fmt::format("an agent ended; see {}/agent{}.log", options_.scratch, i));
}

void Duel::place(std::uint64_t seed) {
  Places places(seed);
  trainer_.send(
      BallCommand{.position = Vec3(places.ball.x(), places.ball.y(), 0.05), .velocity = Vec3::Zero()});
  const Vec2 away = places.ball - Vec2(halfLength, 0);
  const double back = std::atan2(away.y(), away.x()), front = back + pi;
  const auto put = [&](TeamSide side, int number, const Sector& sector) {
    trainer_.send(places.put({number, side}, sector));
  };
  put(TeamSide::left, firstNumber, {0.4, 1.2, back, 2});
  put(TeamSide::right, firstNumber, {0.5, 1.2, front, 1.5});
  for (int i = 1; i < static_cast<int>(types.size()); ++i) {
    put(TeamSide::left, firstNumber + i, {1.5, 4, back, 1});
    put(TeamSide::right, firstNumber + i, {1, 3, front, 1.8});
  }
}

DuelResult Duel::play(std::uint64_t seed) {
  checkAgents();
  setMode(PlayMode::beforeKickOff);
  for (int i = 0; i < restScenes; ++i) nextScene();
  place(seed);
  setMode(PlayMode::playOn);
  const SceneState& scene = trainer_.scene();
  const double begin = scene.time;
  const int left = scene.scoreLeft, right = scene.scoreRight;
  const auto end = [&]() -> std::optional<DuelEnd> {
    if (scene.scoreLeft > left) return DuelEnd::goal;
    if (scene.scoreRight > right) return DuelEnd::ownGoal;
    if (!isPlayedOn(scene.playMode)) {
      const bool line = scene.playMode.starts_with("goal_kick") || scene.playMode.starts_with("corner");
      return line ? DuelEnd::overTheirLine : DuelEnd::overASide;
    }
    if (scene.ball.x() < 0) return DuelEnd::ownHalf;
    if (scene.time - begin > longest) return DuelEnd::timeUp;
    return std::nullopt;
  };
  Watch watch;
  std::optional<DuelEnd> ended;
  while (!ended) {
    nextScene();
    watch.observe(scene);
    ended = end();
  }
  DuelResult result{.end = *ended};
  watch.tell(result);
  return result;
}

}  // namespace plumbline::bench
