#include "simulation/referee/rules/Charging.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/Angle.h"
#include "simulation/referee/Areas.h"

namespace plumbline::simulation {

namespace {

/// Two opponents, the left one first, and the mean of the points where they touched [m].
struct Collision {
  std::array<Participant*, 2> players;
  Vec2 point = Vec2::Zero();
  int points = 0;
};

std::vector<Collision> collisions(Match& match) {
  std::vector<Collision> found;
  for (const RobotContact& contact : match.contacts) {
    Participant *left = match.find(contact.a), *right = match.find(contact.b);
    if (!left || !right || left->side == right->side) continue;
    if (left->side == TeamSide::right) std::swap(left, right);
    auto at = std::find_if(found.begin(), found.end(),
                           [&](const Collision& c) { return c.players[0] == left && c.players[1] == right; });
    if (at == found.end()) at = found.insert(found.end(), {{left, right}, Vec2::Zero(), 0});
    at->point = (at->point * at->points + contact.point.head<2>()) / (at->points + 1);
    ++at->points;
  }
  return found;
}

double angleBetween(const Vec2& a, const Vec2& b) {
  return std::fabs(normalizeAngle(std::atan2(a.y(), a.x()) - std::atan2(b.y(), b.x())));
}

/// In the own penalty area, or behind it.
bool isGoalieAtHome(const FieldSize& field, const Participant& player) {
  const Area area = penaltyArea(field, player.side);
  const Vec2 place = player.place();
  const bool deep = player.side == TeamSide::left ? place.x() <= area.high.x() : place.x() >= area.low.x();
  return player.goalie() && deep && std::fabs(place.y()) <= field.penaltyWidth / 2;
}

/// Changes that are made after all collisions were judged.
struct Outcome {
  int sinceBallTouch, sinceCollision;
  bool fouled = false;
};

class Judge {
public:
  Judge(Match& match, std::vector<Outcome>& outcomes)
      : match_(match), rules_(match.rules.of<Charging>()), outcomes_(outcomes) {}

  void judge(const Collision& collision) {
    const auto& players = collision.players;
    for (const Participant* player : players)
      if (player->notStanding != 0 || player->sinceMoved < match_.cycles(1) || player->offends()) return;
    std::array<bool, 2> atHome{isGoalieAtHome(match_.field, *players[0]),
                               isGoalieAtHome(match_.field, *players[1])};
    std::array<bool, 2> charging = headForEachOther(collision);
    for (std::size_t i = 0; i < 2; ++i) charging[i] = charging[i] && isFast(collision, i);

    for (std::size_t i = 0; i < 2; ++i)
      if (charging[i]) excuse(*players[i], *players[1 - i], atHome[i]);
    const double fromBall = (collision.point - match_.ball().position().head<2>()).norm();
    if ((charging[0] && charging[1]) || fromBall < rules_.minCollisionBallDistance) charging.fill(false);

    for (std::size_t i = 0; i < 2; ++i)
      if (charging[i] && !atHome[i] && players[i]->sinceCollision >= match_.cycles(rules_.minInterval) &&
          players[i]->sinceBallTouch >= match_.cycles(rules_.immunity))
        outcomeOf(*players[i]).fouled = true;
    if (!charging[0] && !charging[1])
      for (const Participant* player : players) outcomeOf(*player).sinceCollision = 0;
  }

private:
  Outcome& outcomeOf(const Participant& player) {
    return outcomes_[static_cast<std::size_t>(&player - match_.participants().data())];
  }

  /// Whether the way of each, seen from the ball, is a charge; away from the ball every way is.
  std::array<bool, 2> headForEachOther(const Collision& collision) {
    const auto& players = collision.players;
    const Vec2 ball = match_.ball().position().head<2>();
    std::array<double, 2> distance{}, speed{}, toOpponent{};
    std::array<bool, 2> charging{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec2 place = players[i]->place(), velocity = players[i]->velocity();
      distance[i] = (ball - place).norm();
      speed[i] = velocity.norm();
      const double toBall = angleBetween(velocity, ball - place);
      toOpponent[i] = angleBetween(velocity, players[1 - i]->place() - place);
      charging[i] = toBall >= toOpponent[i] && toBall >= rules_.minBallAngle && speed[i] >= rules_.minSpeed;
    }
    if (std::min(distance[0], distance[1]) >= rules_.maxBallDistance) return {true, true};
    if (charging[0] || charging[1]) return charging;
    // Both go for the ball: the one that comes second must not run into the first from another direction.
    if (std::fabs(distance[0] - distance[1]) > rules_.minDistanceDifference)
      for (std::size_t i = 0; i < 2; ++i)
        charging[i] = distance[i] > distance[1 - i] &&
                      (std::fabs(toOpponent[0] - toOpponent[1]) > rules_.minAngleDifference ||
                       speed[1 - i] < rules_.minSpeed);
    return charging;
  }

  bool isFast(const Collision& collision, std::size_t i) const {
    const Participant &player = *collision.players[i], &other = *collision.players[1 - i];
    const Vec2 towards = ((collision.point + other.place()) / 2 - player.place()).normalized();
    return player.velocity().norm() >= rules_.minSpeed &&
           player.velocity().dot(towards) >= rules_.minCollisionSpeed;
  }

  /// A player that is charged legally, or was charged just now, is not to blame for what follows.
  void excuse(const Participant& charger, const Participant& victim, bool chargerAtHome) {
    Outcome& outcome = outcomeOf(victim);
    if (chargerAtHome)
      outcome.sinceBallTouch = 0;
    else if (charger.sinceBallTouch < match_.cycles(rules_.immunity))
      outcome.sinceBallTouch = std::min(outcome.sinceBallTouch, charger.sinceBallTouch);
    outcome.sinceCollision = std::min(outcome.sinceCollision, charger.sinceCollision);
  }

  Match& match_;
  const Charging::Parameters& rules_;
  std::vector<Outcome>& outcomes_;
};

}  // namespace

MAKE_RULE(Charging, "charging", 100)

void Charging::judgeAll(Match& match) {
  if (!match.rules.of<Charging>().on || match.contacts.empty()) return;
  std::vector<Outcome> outcomes;
  for (const Participant& player : match.participants())
    outcomes.push_back({player.sinceBallTouch, player.sinceCollision});
  Judge judging(match, outcomes);
  for (const Collision& collision : collisions(match)) judging.judge(collision);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    Participant& player = match.participants()[i];
    player.sinceBallTouch = outcomes[i].sinceBallTouch;
    player.sinceCollision = outcomes[i].sinceCollision;
    if (outcomes[i].fouled) player.commit(Foul::Kind::charging);
  }
}

}  // namespace plumbline::simulation
