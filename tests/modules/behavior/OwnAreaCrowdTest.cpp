#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "math/Random.h"
#include "modules/behavior/Formation.h"
#include "support/ModuleHarness.h"
#include "tactics/OwnArea.h"

using namespace plumbline;

namespace {

constexpr double cycle = 0.02, speed = 0.9;  // [s, m/s]
constexpr double acceleration = 1.3;         // [m/s^2]
constexpr int wordEvery = 22;                // cycles between two messages of a player
constexpr double noise = 0.08;               // of where a player believes to be, per axis [m]
constexpr double lost = 0.1;                 // share of the messages, for each listener

/// A player as a point. It knows where it is, roughly, and of its mates what they said.
struct PointPlayer {
  PointPlayer(int number, const Vec2& at) : place(at) {
    formation.input<PlayerInfo>().number = number;
    formation.input<GameState>().playMode = TeamPlayMode::playOn;
    formation.input<RobotPose>().valid = true;
    formation.input<BallPos>().valid = true;
    formation.input<FieldDimensions>();
    formation.input<FallState>();
    formation.input<OtherRobots>();
    formation.input<TeamRobotPose>();
  }
  const PlayerRole& decide(double time, const Vec2& ball, Random& random) {
    error = 0.99 * error + noise * std::sqrt(1 - 0.99 * 0.99) * Vec2(random.gaussian(), random.gaussian());
    const Vec2 way = ball - place;
    formation.input<FrameInfo>().time = time;
    formation.input<RobotPose>().pose = Pose2(place + error, std::atan2(way.y(), way.x()));
    formation.input<BallPos>().field = ball;
    formation.input<BallPos>().relative = formation.input<RobotPose>().pose.inverse() * ball;
    formation.cycle();
    return formation.output<PlayerRole>();
  }
  /// Straight to where its role wants it, as BehaviorCombinator and SkillCombinator let it.
  void walk(const PlayerRole& role, const Vec2& ball) {
    const Vec2 believed = place + error;
    Vec2 target = role.supports()                    ? role.place.position
                  : role.role == PlayerRole::striker ? ball
                                                     : Vec2(-14.5, 0);
    if (!role.mayBeInOwnArea) target = area.keptOut(target, OwnArea::waitDistance);
    Vec2 wish = 2 * (target - believed);
    if (wish.norm() > speed) wish *= speed / wish.norm();
    if (!role.mayBeInOwnArea) wish = area.stoppedBefore(wish, believed, 0.6);
    const Vec2 change = wish - velocity;
    velocity += std::min(1.0, acceleration * cycle / std::max(change.norm(), 1e-9)) * change;
    place += cycle * velocity;
  }
  Vec2 place, velocity = Vec2::Zero(), error = Vec2::Zero();
  OwnArea area{FieldSize()};
  test::ModuleHarness<Formation> formation;
};

void hear(TeamRobotPose& heard, const TeamReport& report) {
  std::erase_if(heard.reports, [&](const TeamReport& r) { return r.belief.number == report.belief.number; });
  heard.reports.push_back(report);
}

// A ball that jumps about before the own goal draws everybody there.
TEST(OwnAreaCrowdTest, neverAreMoreInTheOwnAreaThanTheRulesAllow) {
  const OwnArea area{FieldSize()};
  int most = 0, atBall = 0, balls = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    std::vector<std::unique_ptr<PointPlayer>> players;
    for (int number = 1; number <= 11; ++number)
      players.push_back(std::make_unique<PointPlayer>(
          number, number == 1 ? Vec2(-14.5, 0) : Vec2(random.uniform(-12.5, -8), random.uniform(-6, 6))));
    Vec2 ball(-13, 0);
    for (int step = 0; step < 3000; ++step) {
      const double time = 30 + step * cycle;
      if (step % 300 == 0) ball = {random.uniform(-14.8, -12.4), random.uniform(-4, 4)};
      double nearest = 100;
      int within = 0;
      for (std::size_t i = 0; i < players.size(); ++i) {
        PointPlayer& player = *players[i];
        const PlayerRole& role = player.decide(time, ball, random);
        player.walk(role, ball);
        if (area.distance(player.place) < 0) ++within;
        nearest = std::min(nearest, (player.place - ball).norm());
        if (step % wordEvery != static_cast<int>(2 * i)) continue;
        TeamReport report;
        report.belief.number = static_cast<int>(i) + 1;
        report.belief.localised = true;
        report.belief.pose = player.formation.input<RobotPose>().pose;
        report.belief.role = role.role;
        report.belief.timeToBall = role.timeToBall;
        report.time = time;
        for (const auto& listener : players)
          if (listener.get() == &player || random.uniform(0, 1) > lost)
            hear(listener->formation.input<TeamRobotPose>(), report);
      }
      most = std::max(most, within);
      if (step % 300 == 299) {
        ++balls;
        if (nearest < 4 * noise) ++atBall;  // as far as a player knows where it is
      }
    }
  }
  EXPECT_LE(most, 3);
  EXPECT_EQ(atBall, balls) << "somebody goes to the ball all the same";
}

}  // namespace
