#include "simulation/referee/SafePlace.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "simulation/referee/Areas.h"
#include "simulation/referee/RobotBox.h"

namespace plumbline::simulation {

namespace {

class Search {
public:
  Search(Match& match, const Participant& player, bool avoidBall)
      : match_(match), player_(player), avoidBall_(avoidBall), radius_(match_.rules.moves.agentRadius) {
    for (const Participant& other : match_.participants())
      if (&other != &player_) boxes_.push_back(robotBox(match_.world, other));
  }

  /// Places a step further in both directions, away from where the player is.
  void sampleAround(const Vec2& place) {
    const Vec2 from = player_.place();
    const double home = sign(player_.side);
    const auto along = [&](double x) {
      if (std::fabs(x) <= match_.field.length / 2) offer(Vec2(x, place.y()));
    };
    if (place.x() == from.x()) {
      along(place.x() + home * radius_);
      along(place.x() - home * radius_);
    } else {
      along(place.x() + (place.x() > from.x() ? radius_ : -radius_));
    }
    if (place.y() == from.y()) {
      const double inwards = from.y() < 0 ? radius_ : -radius_;
      offer(Vec2(place.x(), place.y() + inwards));
      offer(Vec2(place.x(), place.y() - inwards));
    } else {
      offer(Vec2(place.x(), place.y() + (place.y() > from.y() ? radius_ : -radius_)));
    }
  }

  std::optional<Vec2> takeNearest() {
    if (candidates_.empty()) return {};
    const Vec2 place = candidates_.front();
    candidates_.erase(candidates_.begin());
    return place;
  }

  bool isSafe(const Vec3& place) const {
    if (std::fabs(place.x()) > match_.field.length / 2 &&
        std::fabs(place.y()) < match_.field.goalWidth / 2 + radius_)
      return false;
    const Vec2 ball = match_.memory.ball.position().head<2>();
    const double fromBall = std::max(2 * radius_, match_.rules.pass.minOpponentDistance);
    if (avoidBall_ && (ball - place.head<2>()).norm() < fromBall) return false;
    return std::none_of(boxes_.begin(), boxes_.end(),
                        [&](const RobotBox& box) { return box.reachedBy(place, radius_); });
  }

  /// Puts a place in the player's own penalty area, if that is full, to the area's edge. True if it was.
  bool keepOutOfFullArea(Vec2& place) const {
    const std::size_t side = Game::index(player_.side);
    const Area area = penaltyArea(match_.field, player_.side);
    const Area wide = area.widened(radius_);
    const bool full = match_.memory.inOwnArea[side] + match_.memory.movedInside[side] >=
                      match_.rules.illegalDefence.maxInOwnArea;
    const bool inside = place.x() > wide.low.x() && place.x() < wide.high.x() && place.y() > wide.low.y() &&
                        place.y() < wide.high.y();
    if (!match_.rules.illegalDefence.on || player_.inOwnArea || !full || !inside) return false;
    const Vec2 from = player_.place();
    const bool left = player_.side == TeamSide::left;
    if (left ? place.x() > from.x() : place.x() < from.x())
      place.x() = left ? wide.high.x() : wide.low.x();
    else if (place.y() > from.y() || (place.y() == from.y() && place.y() < 0))
      place.y() = wide.high.y();
    else
      place.y() = wide.low.y();
    return true;
  }

private:
  /// In the order of their distance from the player.
  void offer(Vec2 place) {
    keepOutOfFullArea(place);
    const auto near = [&](const Vec2& other) { return (other - place).norm() < radius_ / 2; };
    if (std::any_of(candidates_.begin(), candidates_.end(), near)) return;
    const auto distance = [this](const Vec2& p) { return (p - player_.place()).norm(); };
    const auto at = std::upper_bound(candidates_.begin(), candidates_.end(), place,
                                     [&](const Vec2& a, const Vec2& b) { return distance(a) < distance(b); });
    candidates_.insert(at, place);
  }

  Match& match_;
  const Participant& player_;
  bool avoidBall_;
  double radius_;
  std::vector<RobotBox> boxes_;
  std::vector<Vec2> candidates_;
};

}  // namespace

Vec3 safePlace(Match& match, const Participant& player, const Vec3& wanted, bool avoidBall) {
  const int attempts = match.rules.moves.attempts;
  if (attempts == 0 || match.rules.moves.agentRadius <= 0) return wanted;
  Search search(match, player, avoidBall);
  Vec3 place = wanted;
  if (Vec2 edge = wanted.head<2>(); search.keepOutOfFullArea(edge)) {
    search.sampleAround(wanted.head<2>());
    const auto first = search.takeNearest();
    if (!first) return wanted;
    place.head<2>() = *first;
  }
  bool safe = search.isSafe(place);
  for (int attempt = 1; !safe && attempt < attempts; ++attempt) {
    search.sampleAround(place.head<2>());
    const auto next = search.takeNearest();
    if (!next) break;
    place.head<2>() = *next;
    safe = search.isSafe(place);
  }
  if (!safe) place = wanted;

  const bool inside = penaltyArea(match.field, player.side).contains(place.head<2>());
  int& moved = match.memory.movedInside[Game::index(player.side)];
  if (inside && !player.inOwnArea) ++moved;
  if (!inside && player.inOwnArea) --moved;
  return place;
}

}  // namespace plumbline::simulation
