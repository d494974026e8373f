#include "RefereeFixture.h"
#include "simulation/referee/rules/Charging.h"
#include "simulation/referee/rules/Touching.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

class Touching : public test::RefereeTest {
protected:
  Man &a = add(left, 2, 0, 0), &b = add(left, 3, 0.2, 0), &c = add(right, 4, 0.4, 0),
      &d = add(right, 5, 0.6, 0);
  Touching() { ball(-8, 5); }
  void touch(std::initializer_list<std::pair<const Man*, const Man*>> pairs) {
    world.contacts.clear();
    for (const auto& [one, other] : pairs)
      world.contacts.push_back({one->robot, other->robot, (place(*one) + place(*other)) / 2});
  }
};

TEST_F(Touching, twoMayTouch) {
  playOn();
  touch({{&a, &b}, {&c, &d}});
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Touching, aThirdIsPutAwayFromTheOthers) {
  put(c, 2, 0);
  playOn();
  touch({{&a, &b}});
  cycle();
  put(c, 0.4, 0);
  touch({{&a, &b}, {&b, &c}});
  cycle();
  ASSERT_EQ(fouls().size(), 1u);
  EXPECT_EQ(fouls()[0].first, Foul::Kind::touching);
  EXPECT_TRUE(fouls()[0].second == 2 || fouls()[0].second == 3)
      << "c came last, but the left team has more players in the group";
  EXPECT_EQ(moves(c), 0);
  EXPECT_EQ(moves(a) + moves(b), 1);
}

TEST_F(Touching, theNewcomerGoesIfItsTeamHasAsMany) {
  playOn();
  put(d, 5, 5);
  touch({{&a, &c}});
  cycle();
  put(b, -0.2, 0);
  touch({{&a, &c}, {&b, &a}});
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::touching, 3}}));
  EXPECT_LT((place(b) - Vec3(-0.6, 0, standing)).head<2>().norm(), 0.5) << "0.4 m away, or next to that";
  EXPECT_EQ(game.fouls.count(), 1) << "reported once";
}

TEST_F(Touching, movesTheAgentsRadiusAwayFromTheMiddle) {
  playOn();
  put(d, 5, 5), put(a, 0, 0), put(c, 0, 1.2), put(b, 0, -1.8);
  touch({{&a, &c}});
  cycle();
  touch({{&a, &c}, {&b, &a}});
  cycle();
  EXPECT_LT((place(b) - Vec3(0, -2.2, standing)).norm(), 1e-9);
}

TEST_F(Touching, neverTheGoalie) {
  auto& goalie = add(left, 1, -0.2, 0);
  playOn();
  touch({{&a, &c}});
  cycle();
  touch({{&a, &c}, {&goalie, &a}});
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::touching, 2}})) << "its team mate instead";
}

TEST_F(Touching, groupsGrowThroughOthers) {
  playOn();
  touch({{&a, &b}, {&c, &d}});
  cycle();
  touch({{&a, &b}, {&c, &d}, {&b, &c}});
  cycle();
  EXPECT_EQ(game.fouls.count(), 2) << "of four, two have to go";
}

TEST_F(Touching, isNoFoulWhileTheGameStandsNorIfTheRuleIsOff) {
  touch({{&a, &b}, {&b, &c}, {&c, &d}});
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
  rules.of<simulation::Touching>().on = rules.of<simulation::Charging>().on = false;
  Referee lenient(rules, RandomStream(1));
  game.setMode(PlayMode::playOn);
  Observation seen;
  int id = 0;
  for (const auto& man : men)
    seen.members.push_back({++id, man->side, man->unum, man->robot, &model, &man->frozen});
  for (int i = 0; i < 50; ++i) lenient.update(game, world, seen, dt);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Touching, theRuleMayPutThemOffTheField) {
  rules.of<simulation::Touching>().putOutside = true;
  playOn();
  put(d, 5, 5);
  touch({{&a, &c}});
  cycle();
  touch({{&a, &c}, {&b, &a}});
  cycle();
  touch({{&a, &c}});
  pass(0.5);
  EXPECT_LT((place(b) - Vec3(-2.4, -10.5, 0.4)).norm(), 1e-9);
}

}  // namespace
}  // namespace plumbline::simulation
