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

/// Counts touches of the ball and passes from places alone, as web/summary/js/events.js does for the page of
/// a game. The same file of moments tests both (tests/data/touches/passes.json). Moments are 0.1 s apart.
class BallTouches {
public:
  /// Half of the field's length, and of the goal's width [m]: they decide what is a shot.
  BallTouches(double halfLength, double halfGoal) : halfLength_(halfLength), halfGoal_(halfGoal) {}
  /// The next moment, in their order.
  void observe(BallMoment moment);

  /// The ball becomes `touchGain` faster or turns, and a player is within `touchReach`.
  int touches(simspark::TeamSide side) const { return touches_[index(side)]; }
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
  static constexpr double touchPause = 0.4;  ///< what a player does within it is one touch [s]
  static constexpr double passWay = 1.5;     ///< [m]

private:
  struct Touch {
    BallMoment::Player player{};
    Vec2 place = Vec2::Zero(), velocity = Vec2::Zero();
    double time = 0;
    int course = 0;
  };
  static std::size_t index(simspark::TeamSide side) { return side == simspark::TeamSide::right ? 1 : 0; }
  void look(const Vec2& before, const Vec2& after);
  bool isShot(const Touch& touch) const;
  void count(const Touch& touch, const Touch& next);

  double halfLength_, halfGoal_;
  std::optional<BallMoment> last_;  ///< the moment before
  std::optional<Vec2> velocity_;    ///< of the ball up to it
  std::optional<Touch> lastTouch_;
  std::string mode_{};
  int course_ = 0;
  std::array<int, 2> touches_{}, made_{}, completed_{};
};

}  // namespace plumbline::watch
