#pragma once
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "simspark/SceneState.h"
#include "watch/BallTouches.h"

namespace plumbline::watch {

/// Counts what happens in a game from the scenes a monitor gets: falls, kicks, shots, passes and fouls of
/// each team. Positions there are exact to 5 mm, so what is counted is what was to be seen, on any server.
class GameCounter {
public:
  /// The next scene, in their order.
  void observe(const simspark::SceneState& scene);

  /// A robot that stood (torso within 25 degrees of upright) and then leans by more than 60 degrees while the
  /// game clock runs; again only after it has stood again.
  int falls(simspark::TeamSide side) const { return falls_[index(side)]; }
  /// The ball gets at least `kickGain` faster while the game clock runs; the kick is that of the robot
  /// nearest to it, which is within `kickReach`. What a robot does within `kickPause` is one kick. Touches in
  /// walking are slower.
  int kicks(simspark::TeamSide side) const { return kicks_[index(side)]; }
  /// Fouls that the referee called. The server tells one in every cycle until the player is put elsewhere;
  /// here it counts once.
  int fouls(simspark::TeamSide side, simspark::FoulKind kind) const {
    return fouls_[index(side)][static_cast<std::size_t>(kind)];
  }
  /// Free kicks that the other team got, because a player touched the ball twice at an own restart.
  int freeKicksAgainst(simspark::TeamSide side) const { return freeKicksAgainst_[index(side)]; }
  /// What a shot is, BallTouches says.
  int shots(simspark::TeamSide side) const { return touches_ ? touches_->shots(side) : 0; }
  /// Passes of a team, made and those that a mate gets; see BallTouches.
  int passesMade(simspark::TeamSide side) const { return touches_ ? touches_->passesMade(side) : 0; }
  int passesCompleted(simspark::TeamSide side) const {
    return touches_ ? touches_->passesCompleted(side) : 0;
  }
  /// Most players of a team that were there at once.
  int players(simspark::TeamSide side) const { return players_[index(side)]; }

  static constexpr double kickGain = 1.5;     ///< [m/s]
  static constexpr double kickReach = 0.6;    ///< from the ball to the middle of the torso, on the ground [m]
  static constexpr double kickPause = 0.5;    ///< [s]
  static constexpr double maxBallSpeed = 25;  ///< what is faster was carried by the referee [m/s]

private:
  static std::size_t index(simspark::TeamSide side) { return side == simspark::TeamSide::right ? 1 : 0; }
  void countFalls(const simspark::SceneState& scene, bool running);
  void countKicks(const simspark::SceneState& scene);
  void countFouls(const simspark::SceneState& scene);
  void countPasses(const simspark::SceneState& scene);

  using Offence = std::tuple<simspark::TeamSide, int, simspark::FoulKind>;  ///< the int: uniform number
  struct Stance {
    bool stood = false, fallen = false;
  };
  std::map<std::pair<simspark::TeamSide, int>, Stance> stances_;
  std::array<int, 2> falls_{}, kicks_{}, players_{}, freeKicksAgainst_{};
  std::array<std::array<int, static_cast<std::size_t>(simspark::FoulKind::none)>, 2> fouls_{};
  std::set<Offence> lastOffences_;  ///< of the scene before
  std::string lastMode_;            ///< play mode, likewise
  std::optional<double> lastTime_;
  Vec2 lastBall_ = Vec2::Zero();
  std::optional<Vec2> lastVelocity_;
  double lastKick_ = -1e9;
  std::optional<BallTouches> touches_;  ///< from the first scene on, which says how large the field is
};

}  // namespace plumbline::watch
