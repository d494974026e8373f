#include "watch/BallTouches.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace plumbline::watch {

namespace {

constexpr double moving = 0.5, carriedSpeed = 15;  // [m/s]
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
  if (moment.mode != mode_) {
    if (moment.mode == "Goal_Left") goal_ = {simspark::TeamSide::left, course_};
    if (moment.mode == "Goal_Right") goal_ = {simspark::TeamSide::right, course_};
    if (!isPlay(moment.mode)) ++course_;
  }
  mode_ = moment.mode;
  if (last_) {
    const double step = moment.time - last_->time;
    if (step > 0 && step < pageStep) return;
    const std::optional<Vec2> after = velocityOf(*last_, moment);
    const std::optional<Vec2> before = std::exchange(velocity_, after);
    if (before && after && !isRest(last_->mode)) look(*before, *after);
  }
  // Only now, as the last touch before a goal may be that of the moment before.
  if (const auto goal = std::exchange(goal_, std::nullopt)) countGoal(*goal);
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
  if (lastTouch_ && last_->time - lastTouch_->time < touchPause && isSameTouch(*nearest, after)) {
    if (is > lastTouch_->velocity.norm()) {
      lastTouch_->velocity = after;
      setShot(goesToTheGoal(*lastTouch_));
    }
    return;
  }
  const Touch touch{*nearest, last_->ball, after, last_->time, last_->course};
  ++touches_[index(touch.player.side)];
  if (lastTouch_) count(*lastTouch_, touch);
  lastTouch_ = touch;
  setShot(goesToTheGoal(touch));
}

bool BallTouches::isSameTouch(const BallMoment::Player& player, const Vec2& velocity) const {
  if (player.side == lastTouch_->player.side && player.number == lastTouch_->player.number) return true;
  const Vec2& way = lastTouch_->velocity;
  return way.dot(velocity) >= turnedCosine * way.norm() * velocity.norm();
}

void BallTouches::countGoal(const Goal& goal) {
  if (!lastTouch_ || lastTouch_->course != goal.course)
    ++shots_[index(goal.side)];
  else if (lastTouch_->player.side == goal.side)
    setShot(true);
}

void BallTouches::setShot(bool shot) {
  shots_[index(lastTouch_->player.side)] += static_cast<int>(shot) - static_cast<int>(lastTouch_->shot);
  lastTouch_->shot = shot;
}

bool BallTouches::goesToTheGoal(const Touch& touch) const {
  const double goal = touch.player.side == simspark::TeamSide::right ? -halfLength_ : halfLength_;
  const double left = std::abs(goal - touch.place.x()), speed = touch.velocity.norm();
  const double way = (goal - touch.place.x()) / touch.velocity.x();
  if (speed < shotSpeed || !(way > 0 && way < shotSeconds) || left > shotReach) return false;
  return std::abs(touch.place.y() + way * touch.velocity.y()) < halfGoal_ + mostMiss;
}

void BallTouches::count(const Touch& touch, const Touch& next) {
  const bool mate = touch.player.side == next.player.side;
  const bool same = mate && touch.player.number == next.player.number;
  const bool near = (touch.place - next.place).norm() < passWay;
  if (same && near && touch.course == next.course) setShot(false);
  if (same || near || touch.shot) return;
  ++made_[index(touch.player.side)];
  if (mate && touch.course == next.course) ++completed_[index(touch.player.side)];
}

}  // namespace plumbline::watch
