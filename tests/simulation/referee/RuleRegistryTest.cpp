#include "simulation/referee/RuleRegistry.h"

#include <gtest/gtest.h>

#include "RefereeFixture.h"
#include "simulation/referee/rules/Charging.h"
#include "simulation/referee/rules/Touching.h"

namespace plumbline::test {
namespace {

using namespace simulation;

/// A rule of its own: nobody may be more than a metre above the ground.
class NoFlying : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, false, "", {}, "whether it is a foul")
    PARAMETER(double, highest, 1, "m", Range(0, 10), "of the torso")
  };
  void judgePlayer(Match& match, Participant& player) override {
    const Parameters& rules = match.rules.of<NoFlying>();
    if (rules.on && player.torso.pose.translation().z() > rules.highest) player.commit(Foul::Kind::crowding);
  }
};
MAKE_RULE(NoFlying, "noFlying", 135)

/// Between two others, as its number says; the league's order is that of the others.
TEST(RuleRegistry, rulesComeInTheOrderOfTheirNumbers) {
  std::vector<std::string> names;
  for (const RuleEntry& rule : registeredRules()) names.push_back(rule.name);
  EXPECT_EQ(names, (std::vector<std::string>{"halfTime", "kickOff", "startPlace", "passMode", "doubleTouch",
                                             "goals", "ballOut", "restart", "charging", "selfCollision",
                                             "crowding", "illegalDefence", "noFlying", "incapable",
                                             "touching", "penalty", "lostMessages"}));
}

TEST(RuleRegistry, parametersAreCopiedAndComparedWithTheRules) {
  Rules rules;
  Rules other = rules;
  EXPECT_EQ(rules, other);
  other.of<NoFlying>().highest = 2;
  EXPECT_EQ(rules.of<NoFlying>().highest, 1);
  EXPECT_NE(rules, other);
  other = rules;
  EXPECT_EQ(rules, other);
}

class OwnRule : public RefereeTest {};

TEST_F(OwnRule, isJudgedWithTheOthers) {
  rules.of<NoFlying>().on = true;
  add(left, 2, 3, 3, 1.5);
  add(right, 3, -3, 3);
  ball(8, 0);
  playOn();
  EXPECT_EQ(fouls(), (std::vector<std::pair<Foul::Kind, int>>{{Foul::Kind::crowding, 2}}));
}

}  // namespace
}  // namespace plumbline::test
