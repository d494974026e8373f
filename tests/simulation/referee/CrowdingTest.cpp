#include "RefereeFixture.h"
#include "simulation/referee/rules/Crowding.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

class Crowding : public test::RefereeTest {
protected:
  Man &first = add(left, 2, 0.3, 0), &second = add(left, 3, 0, 0.38), &third = add(left, 4, -0.9, 0);
  Man& opponent = add(right, 2, 0, -0.7);
};

TEST_F(Crowding, isAllowedInTheLeague) {
  playOn();
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Crowding, theSecondAndTheThirdHaveToGoIfTheRuleIsOn) {
  rules.of<simulation::Crowding>().on = true;
  playOn();
  std::map<int, int> called;
  for (const Foul& foul : game.fouls.since(0)) {
    EXPECT_EQ(foul.kind, Foul::Kind::crowding);
    ++called[foul.unum];
  }
  EXPECT_EQ(called, (std::map<int, int>{{3, 1}, {4, 1}}));
}

TEST_F(Crowding, isSeenWhereverTheBallIs) {
  rules.of<simulation::Crowding>().on = true;
  for (const Man* man : {&first, &second, &third, &opponent})
    put(*man, place(*man).x() + 4, place(*man).y() - 3);
  ball(4, -3);
  playOn();
  std::map<int, int> called;
  for (const Foul& foul : game.fouls.since(0)) ++called[foul.unum];
  EXPECT_EQ(called, (std::map<int, int>{{3, 1}, {4, 1}}));
}

TEST_F(Crowding, withoutAnOpponentNearItIsAllowed) {
  rules.of<simulation::Crowding>().on = true;
  put(opponent, 0, -0.9);
  playOn();
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Crowding, farEnoughIsAllowed) {
  rules.of<simulation::Crowding>().on = true;
  put(second, 0, 0.42);
  put(third, -1.02, 0);
  playOn();
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Crowding, theTeamThatKicksOffMay) {
  rules.of<simulation::Crowding>().on = true;
  put(second, -0.3, 0.2), put(first, -0.3, 0);
  put(opponent, 5, 5);
  game.setMode(PlayMode::kickOffLeft);
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
}

}  // namespace
}  // namespace plumbline::simulation
