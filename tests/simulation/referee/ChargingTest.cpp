#include "RefereeFixture.h"
#include "simulation/referee/rules/Charging.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

/// A left player runs along x into a right one that stands.
class Charging : public test::RefereeTest {
protected:
  Man &charger = add(left, 5, 0, 0), &victim = add(right, 6, 0.3, 0);
  Charging() { ball(-8, 5); }
  void collide(double speed = 0.6) {
    setVelocity(charger, speed, 0);
    pass(0.06);
    world.contacts = {{charger.robot, victim.robot, Vec3(0.15, 0, 0.3)}};
    cycle();
    world.contacts.clear();
  }
  void expectFoul(int of) {
    ASSERT_EQ(fouls().size(), 1u);
    EXPECT_EQ(fouls()[0], std::pair(Foul::Kind::charging, of));
  }
};

TEST_F(Charging, whoRunsIntoAnOpponentIsPutOffTheField) {
  playOn();
  collide();
  expectFoul(5);
  EXPECT_NEAR(place(charger).z(), 1.02, 1e-9);
  pass(0.5);
  EXPECT_LT((place(charger) - Vec3(-1.2, -10.5, 0.4)).norm(), 1e-9);
  EXPECT_EQ(moves(victim), 0);
}

TEST_F(Charging, slowlyIsNoFoul) {
  playOn();
  collide(0.39);
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, sidewaysIsNoFoul) {
  playOn();
  setVelocity(charger, 0.15, 0.6);
  pass(0.06);
  world.contacts = {{charger.robot, victim.robot, Vec3(0.15, 0, 0.3)}};
  cycle();
  EXPECT_EQ(fouls(), Fouls{}) << "0.15 m/s towards the collision";
}

TEST_F(Charging, ifBothChargeNobodyDoes) {
  playOn();
  setVelocity(victim, -0.6, 0);
  collide();
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, onTheWayToTheBallIsNoFoul) {
  ball(0.9, 0);
  playOn();
  collide();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::charging, 5}}))
      << "the victim is nearer to the ball and stands, so who comes second charges";
}

TEST_F(Charging, whoIsNearerToTheBallMayGoThere) {
  ball(0.25, 0.45);
  put(charger, 0, 0.1);
  put(victim, 0.4, -0.3);
  playOn();
  setVelocity(charger, 0.4, 0.45);  // rather to the ball than to the opponent
  pass(0.06);
  world.contacts = {{charger.robot, victim.robot, Vec3(0.2, -0.1, 0.3)}};
  cycle();
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, whoGoesForTheOpponentInsteadOfTheBallCharges) {
  ball(0, 0.8);
  playOn();
  collide();  // the ball lies at a right angle to its way
  expectFoul(5);
}

TEST_F(Charging, atTheBallItselfIsNoFoul) {
  ball(0.15, 0.05);
  playOn();
  collide();
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, withinASecondOfTouchingTheBallIsNoFoul) {
  playOn(&charger);
  pass(0.8);
  collide();
  EXPECT_EQ(fouls(), Fouls{});
  pass(0.3);
  collide();
  expectFoul(5);
}

TEST_F(Charging, theGoalieMayInItsArea) {
  auto& goalie = add(left, 1, -14, 0);
  auto& attacker = add(right, 9, -13.7, 0);
  playOn();
  setVelocity(goalie, 0.6, 0);
  pass(0.06);
  world.contacts = {{goalie.robot, attacker.robot, Vec3(-13.85, 0, 0.3)}};
  cycle();
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, shortlyAfterAHarmlessCollisionIsNoFoul) {
  playOn();
  collide(0.1);
  collide(0.6);
  EXPECT_EQ(fouls(), Fouls{});
  pass(0.3);
  collide();
  expectFoul(5);
}

TEST_F(Charging, shortlyAfterBeingChargedItIsAFoulAgain) {
  auto& other = add(left, 7, 3, 0);
  playOn();
  collide();
  expectFoul(5);
  setVelocity(victim, 0.6, 0);
  put(other, 0.6, 0);
  pass(0.06);
  world.contacts = {{other.robot, victim.robot, Vec3(0.45, 0, 0.3)}};
  cycle();
  ASSERT_EQ(fouls().size(), 2u) << "a foul is no harmless collision";
  EXPECT_EQ(fouls()[1], std::pair(Foul::Kind::charging, -6)) << "of the right team";
}

TEST_F(Charging, whoDoesNotStandIsNotJudged) {
  put(charger, 0, 0, 0.2);
  playOn();
  collide();
  EXPECT_EQ(fouls(), Fouls{});
}

TEST_F(Charging, isNoFoulIfTheRuleIsOff) {
  rules.of<simulation::Charging>().on = false;
  playOn();
  collide(2);
  EXPECT_EQ(fouls(), Fouls{});
}

}  // namespace
}  // namespace plumbline::simulation
