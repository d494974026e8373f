#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "math/Types.h"
#include "simspark/TeamSide.h"

namespace plumbline::watch {

/// Where everybody is at a moment of a game.
struct BallMoment {
  struct Player {
    simspark::TeamSide side = simspark::TeamSide::none;
    int number = 0;
    Vec2 place = Vec2::Zero();  ///< [m, server's field]
  };
  double time = 0;     ///< on the game's clock [s]
  std::string mode{};  ///< the server's play mode
  Vec2 ball = Vec2::Zero();
  std::vector<Player> players{};
  int course = 0;  ///< of play, which BallTouches counts: a restart begins another one
};

/// Counts touches of the ball, shots and passes from places and play modes alone, as web/summary/js/events.js
/// does for the page of a game. The same files of moments test both (tests/data/touches). Moments are 0.1 s
/// apart.
///
/// A shot is a touch after which the ball goes towards the goal that the team plays at, with `shotSpeed` or
/// more, from `shotReach` at most. On its line it comes to the goal's mouth or `mostMiss` beside it, at this
/// speed within `shotSeconds`: slower balls stop short of the goal. If the same player touches it again
/// within `passWay`, that was dribbling. Every goal is a shot, too: of who touched the ball last, if that is
/// a player of the team. The touch of an opponent is none, be it an own goal or a shot that it deflects: that
/// counted when it left the foot.
class BallTouches {
public:
  /// Half of the field's length, and of the goal's width [m].
  BallTouches(double halfLength, double halfGoal) : halfLength_(halfLength), halfGoal_(halfGoal) {}
  /// The next moment, in their order.
  void observe(BallMoment moment);

  /// The ball becomes `touchGain` faster or turns, and a player is within `touchReach`.
  int touches(simspark::TeamSide side) const { return touches_[index(side)]; }
  int shots(simspark::TeamSide side) const { return shots_[index(side)]; }
  /// Touches that are no shots and after which another player has the next touch, `passWay` away or farther.
  int passesMade(simspark::TeamSide side) const { return made_[index(side)]; }
  /// Those whose next touch is a mate's before the ball goes out of play.
  int passesCompleted(simspark::TeamSide side) const { return completed_[index(side)]; }

  /// Who has touched the ball last; nobody yet: empty.
  std::optional<BallMoment::Player> lastTouch() const {
    return lastTouch_ ? std::optional(lastTouch_->player) : std::nullopt;
  }

  static constexpr double touchGain = 0.8;   ///< [m/s]
  static constexpr double touchReach = 0.5;  ///< [m]
  /// What a player does within it is one touch, and so is what makes the ball faster in the same direction:
  /// another player may be nearer to it at the end of a kick [s].
  static constexpr double touchPause = 0.4;
  static constexpr double passWay = 1.5;    ///< [m]
  static constexpr double shotSpeed = 1.5;  ///< [m/s]
  static constexpr double shotReach = 12;   ///< to the goal line [m]
  static constexpr double mostMiss = 0.5;   ///< [m]
  static constexpr double shotSeconds = 2;  ///< balls go 1 to 2 s times the speed that a kick gives them

private:
  struct Touch {
    BallMoment::Player player{};
    Vec2 place = Vec2::Zero(), velocity = Vec2::Zero();
    double time = 0;
    int course = 0;
    bool shot = false;
  };
  static std::size_t index(simspark::TeamSide side) { return side == simspark::TeamSide::right ? 1 : 0; }
  void look(const Vec2& before, const Vec2& after);
  struct Goal {
    simspark::TeamSide side = simspark::TeamSide::none;  ///< whose goal it is
    int course = 0;                                      ///< in which it fell
  };
  /// Whether the last touch goes on when the ball, near this player, gets this velocity.
  bool isSameTouch(const BallMoment::Player& player, const Vec2& velocity) const;
  bool goesToTheGoal(const Touch& touch) const;
  void countGoal(const Goal& goal);
  /// Whether the last touch is a shot, as far as is known by now.
  void setShot(bool shot);
  void count(const Touch& touch, const Touch& next);

  double halfLength_, halfGoal_;
  std::optional<BallMoment> last_;  ///< the moment before
  std::optional<Vec2> velocity_;    ///< of the ball up to it
  std::optional<Touch> lastTouch_;
  std::optional<Goal> goal_;  ///< that is not counted yet
  std::string mode_{};
  int course_ = 0;
  std::array<int, 2> touches_{}, shots_{}, made_{}, completed_{};
};

}  // namespace plumbline::watch
