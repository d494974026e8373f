#include "Duel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "field/FieldSize.h"
#include "math/Angle.h"
#include "math/Random.h"
#include "watch/GameCounter.h"

namespace plumbline::bench {
namespace {

using namespace simspark;

const std::vector<int> types = {4, 3, 2};  // of a team's robots, numbers 2 to 4: there is no goalie
constexpr int firstNumber = 2;
constexpr const char* attack = "Attack";                // the left team's name
const double halfLength = FieldSize().length / 2;       // [m]
constexpr double nearest = 1, farthest = 6, aside = 4;  // the ball's place before the goal [m]
constexpr double robotHeight = 0.4;                     // of a torso that is put upright [m]
constexpr double apart = 0.4;                           // of robots that are put [m]
constexpr double faces = 0.5;                           // how far from the ball at most [rad]

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

bool isPlayedOn(const std::string& mode) {
  return mode == playModeName(PlayMode::playOn) || mode.starts_with("pass");
}

TrainedTeam attackersOf(const DuelOptions& options) {
  return {attack, options.attackers, {}, types, firstNumber};
}

TrainedTeam defendersOf(const DuelOptions& options) {
  return {"Defence", options.programs, {"--modules", options.defence}, types, firstNumber};
}

}  // namespace

Duel::Duel(const DuelOptions& options, std::uint64_t seed)
    : game_(options.programs, options.scratch, seed, attackersOf(options), defendersOf(options)) {}

void Duel::place(std::uint64_t seed) {
  Places places(seed);
  game_.send(BallCommand{.position = Vec3(places.ball.x(), places.ball.y(), 0.05), .velocity = Vec3::Zero()});
  const Vec2 away = places.ball - Vec2(halfLength, 0);
  const double back = std::atan2(away.y(), away.x()), front = back + pi;
  const auto put = [&](TeamSide side, int number, const Sector& sector) {
    game_.send(places.put({number, side}, sector));
  };
  put(TeamSide::left, firstNumber, {0.4, 1.2, back, 2});
  put(TeamSide::right, firstNumber, {0.5, 1.2, front, 1.5});
  for (int i = 1; i < static_cast<int>(types.size()); ++i) {
    put(TeamSide::left, firstNumber + i, {1.5, 4, back, 1});
    put(TeamSide::right, firstNumber + i, {1, 3, front, 1.8});
  }
}

DuelResult Duel::play(std::uint64_t seed) {
  game_.begin();
  place(seed);
  game_.setMode(PlayMode::playOn);
  const SceneState& scene = game_.scene();
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
    game_.nextScene();
    watch.observe(scene);
    ended = end();
  }
  DuelResult result{.end = *ended};
  watch.tell(result);
  return result;
}

}  // namespace plumbline::bench
