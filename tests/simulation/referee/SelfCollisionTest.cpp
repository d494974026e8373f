#include <algorithm>

#include "RefereeFixture.h"
#include "simulation/ArmIntoTorso.h"
#include "simulation/referee/rules/SelfCollision.h"

namespace plumbline::simulation {
namespace {

using Fouls = std::vector<std::pair<Foul::Kind, int>>;

class SelfCollision : public test::RefereeTest {
protected:
  Man& player = add(left, 3, 0, 0);
  SelfCollision() { ball(-8, 5); }
  void armIntoTorso() { world.setPosture(player.robot, test::armIntoTorso()); }
  void straight() { world.setPosture(player.robot, JointArray{}); }
  bool armFrozen() const {
    for (int joint = lShoulderPitch; joint <= lElbowRoll; ++joint)
      if (!player.frozen[static_cast<std::size_t>(joint)]) return false;
    return true;
  }
};

TEST_F(SelfCollision, standingStraightIsNone) {
  playOn();
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
  EXPECT_TRUE(player.frozen.none());
}

TEST_F(SelfCollision, freezesTheArmForASecondThenThawsForTwo) {
  playOn();
  armIntoTorso();
  cycle();
  EXPECT_EQ(fouls(), (Fouls{{Foul::Kind::selfCollision, 3}}));
  EXPECT_TRUE(armFrozen());
  EXPECT_EQ(player.frozen.count(), 4u) << "the other arm and the legs are free";
  EXPECT_EQ(moves(player), 0);
  pass(0.98);
  EXPECT_TRUE(armFrozen());
  pass(0.04);
  EXPECT_TRUE(player.frozen.none());
  pass(1.9);
  EXPECT_EQ(game.fouls.count(), 1) << "cannot be frozen again yet";
  pass(0.14);
  EXPECT_EQ(game.fouls.count(), 2);
  EXPECT_TRUE(armFrozen());
}

TEST_F(SelfCollision, whileTheGameStandsEverythingIsFree) {
  playOn();
  armIntoTorso();
  cycle();
  EXPECT_TRUE(armFrozen());
  game.setMode(PlayMode::goalLeft);
  cycle();
  EXPECT_TRUE(player.frozen.none());
}

TEST_F(SelfCollision, legsThroughEachOther) {
  JointArray angles{};
  angles[lHipRoll] = fromDegrees(-20);
  angles[lHipPitch] = fromDegrees(-10);
  angles[lKneePitch] = fromDegrees(50);
  angles[rHipRoll] = fromDegrees(20);
  angles[rHipPitch] = fromDegrees(-10);
  playOn();
  world.setPosture(player.robot, angles);
  cycle();
  EXPECT_GT(game.fouls.count(), 0);
  EXPECT_TRUE(player.frozen[lKneePitch] && player.frozen[rKneePitch]);
  EXPECT_FALSE(player.frozen[lShoulderPitch] || player.frozen[headYaw]);
}

TEST_F(SelfCollision, knowsLimbsByTheTreeOfLinksWhateverTheirNames) {
  RobotModel renamed = model;
  for (Link& link : renamed.links) link.name = "part";
  constexpr double nearly = -1;  // [m]: also boxes that do not touch
  const auto expected = limbCollisions(world, player.robot, model, nearly);
  const auto found = limbCollisions(world, player.robot, renamed, nearly);
  ASSERT_GT(expected.size(), 4u) << "among them each arm with the torso, which it hangs on";
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i].a == expected[i].a && found[i].b == expected[i].b);
  const auto arms = std::ranges::count_if(found, [](const LimbCollision& each) {
    return each.a.none() && (each.b.test(lElbowRoll) || each.b.test(rElbowRoll));
  });
  EXPECT_GE(arms, 2);
}

TEST_F(SelfCollision, isNoFoulIfTheRuleIsOff) {
  rules.of<simulation::SelfCollision>().on = false;
  playOn();
  armIntoTorso();
  pass(1);
  EXPECT_EQ(fouls(), Fouls{});
  EXPECT_TRUE(player.frozen.none());
}

TEST_F(SelfCollision, theRuleMayPutThemOffTheFieldInstead) {
  rules.of<simulation::SelfCollision>().putOutside = true;
  playOn();
  armIntoTorso();
  pass(0.52);
  EXPECT_TRUE(player.frozen.none());
  EXPECT_LT((place(player) - Vec3(-2.4, -10.5, 0.4)).norm(), 1e-9);
  const int before = moves(player);
  pass(9);
  EXPECT_EQ(moves(player), before) << "not again for ten seconds";
  pass(1.6);
  EXPECT_GT(moves(player), before);
}

}  // namespace
}  // namespace plumbline::simulation
