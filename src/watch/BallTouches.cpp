#include "watch/BallTouches.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace plumbline::watch {

namespace {

constexpr double shotSpeed = 1.5, shotReach = 12, mostMiss = 0.5;  // [m/s, m]
constexpr double moving = 0.5, carriedSpeed = 15;                  // [m/s]
constexpr double pageStep = 0.099;  // a server may send scenes more often than the page keeps them [s]
constexpr double leastStep = 0.01, mostStep = 1;  // between two moments [s]
const double turnedCosine = std::cos(std::numbers::pi / 5);

/// In these nobody plays: the ball is put somewhere.
bool isRest(const std::string& mode) {
  return mode == "BeforeKickOff" || mode == "GameOver" || mode.starts_with("Goal_");
}

/// In these the ball has gone on since the touch before.
bool isPlay(const std::string& mode) { return mode == "PlayOn" || mode.starts_with("pass"); }

std::optional<Vec2> velocityOf(const BallMoment& from, const BallMoment& to) {
  const double step = to.time - from.time;
  if (!(step > leastStep && step < mostStep)) return std::nullopt;
  const Vec2 velocity = (to.ball - from.ball) / step;
  if (velocity.norm() > carriedSpeed) return std::nullopt;  // by the referee
  return velocity;
}

}  // namespace

void BallTouches::observe(BallMoment moment) {
  if (moment.mode != mode_ && !isPlay(moment.mode)) ++course_;
  mode_ = moment.mode;
  if (last_) {
    const double step = moment.time - last_->time;
    if (step > 0 && step < pageStep) return;
    const std::optional<Vec2> after = velocityOf(*last_, moment);
    const std::optional<Vec2> before = std::exchange(velocity_, after);
    if (before && after && !isRest(last_->mode)) look(*before, *after);
  }
  moment.course = course_;
  last_ = std::move(moment);
}

void BallTouches::look(const Vec2& before, const Vec2& after) {
  const double was = before.norm(), is = after.norm();
  const bool bends = was > moving && is > moving && before.dot(after) < turnedCosine * was * is;
  if (is - was < touchGain && !bends) return;
  const BallMoment::Player* nearest = nullptr;
  double least = touchReach;
  for (const BallMoment::Player& player : last_->players) {
    const double distance = (player.place - last_->ball).norm();
    if (player.side == simspark::TeamSide::none || distance > least || (nearest && distance == least))
      continue;
    nearest = &player;
    least = distance;
  }
  if (!nearest) return;
  if (lastTouch_ && lastTouch_->player.side == nearest->side &&
      lastTouch_->player.number == nearest->number && last_->time - lastTouch_->time < touchPause) {
    if (is > lastTouch_->velocity.norm()) lastTouch_->velocity = after;
    return;
  }
  const Touch touch{*nearest, last_->ball, after, last_->time, last_->course};
  ++touches_[index(touch.player.side)];
  if (lastTouch_) count(*lastTouch_, touch);
  lastTouch_ = touch;
}

bool BallTouches::isShot(const Touch& touch) const {
  const double goal = touch.player.side == simspark::TeamSide::right ? -halfLength_ : halfLength_;
  const double way = (goal - touch.place.x()) / touch.velocity.x();
  if (touch.velocity.norm() < shotSpeed || !(way > 0) || std::abs(goal - touch.place.x()) > shotReach)
    return false;
  return std::abs(touch.place.y() + way * touch.velocity.y()) < halfGoal_ + mostMiss;
}

void BallTouches::count(const Touch& touch, const Touch& next) {
  const bool mate = touch.player.side == next.player.side;
  if ((mate && touch.player.number == next.player.number) || (touch.place - next.place).norm() < passWay ||
      isShot(touch))
    return;
  ++made_[index(touch.player.side)];
  if (mate && touch.course == next.course) ++completed_[index(touch.player.side)];
}

}  // namespace plumbline::watch
