#include "simulation/referee/rules/StartPlace.h"

#include "RefereeFixture.h"

namespace plumbline::simulation {
namespace {

class StartPlaceTest : public test::RefereeTest {};

TEST_F(StartPlaceTest, theBallLiesThereAtTheKickOff) {
  rules.of<StartPlace>().on = true;
  rules.of<StartPlace>().x = 9;
  rules.of<StartPlace>().y = -3;
  rules.kickOff.after = 2;
  rules.of<StartPlace>().robotX = 7;
  rules.of<StartPlace>().robotY = 2;
  rules.moves.startAnywhere = true;
  auto &first = add(left, 1, -3, 0), &second = add(left, 2, -3, 4);
  pass(1);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042)) << "not before it";
  EXPECT_EQ(place(first).x(), -3);
  pass(2);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  EXPECT_LT((ball() - Vec3(9, -3, 0.042)).norm(), 1e-9);
  EXPECT_LT((place(first).head<2>() - Vec2(7, 2)).norm(), 1e-9);
  EXPECT_EQ(place(second).x(), -3);
}

TEST_F(StartPlaceTest, theBallMayBeShotFromThere) {
  rules.of<StartPlace>().on = true;
  rules.of<StartPlace>().x = -10;
  rules.of<StartPlace>().speedX = -8;
  rules.of<StartPlace>().speedZ = 2;
  rules.kickOff.after = 2;
  add(left, 1, -3, 0);
  pass(3);
  EXPECT_EQ(world.ballState.linearVelocity, Vec3(-8, 0, 2));
  EXPECT_EQ(ball(), Vec3(-10, 0, 0.042));
}

TEST_F(StartPlaceTest, inTheLeagueItLiesInTheMiddle) {
  rules.of<StartPlace>().x = 9;
  rules.kickOff.after = 2;
  add(left, 2, -3, 0);
  pass(3);
  EXPECT_EQ(game.mode, PlayMode::kickOffLeft);
  EXPECT_EQ(ball(), Vec3(0, 0, 0.042));
}

}  // namespace
}  // namespace plumbline::simulation
