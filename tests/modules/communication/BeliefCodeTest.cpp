#include "modules/communication/code/BeliefCode.h"

#include <gtest/gtest.h>

#include "field/FieldFile.h"
#include "math/Random.h"

using namespace plumbline;

namespace {

TeamBelief someBelief(Random& random) {
  TeamBelief belief;
  belief.number = 1 + static_cast<int>(random.next() % 11);
  belief.pose = Pose2(random.uniform(-15, 15), random.uniform(-10, 10), random.uniform(-3.1, 3.1));
  belief.localised = random.uniform() < 0.9;
  belief.fallen = random.uniform() < 0.2;
  belief.role = static_cast<int>(random.next() % 12);
  belief.timeToBall = random.uniform(0, 16);
  belief.ballKnown = random.uniform() < 0.8;
  belief.ballAge = random.uniform(0, 8);
  belief.ball = Vec2(random.uniform(-15, 15), random.uniform(-10, 10));
  belief.ballVelocity = Vec2(random.uniform(-7, 7), random.uniform(-7, 7));
  for (int i = static_cast<int>(random.next() % 3); i > 0; --i) {
    SaidOpponent& opponent = belief.opponents.emplace_back();
    opponent.number = 1 + static_cast<int>(random.next() % 11);
    opponent.position = Vec2(random.uniform(-15, 15), random.uniform(-10, 10));
  }
  return belief;
}

void expectNear(const Vec2& a, const Vec2& b, double x, double y) {
  EXPECT_NEAR(a.x(), b.x(), x);
  EXPECT_NEAR(a.y(), b.y(), y);
}

TEST(BeliefCodeTest, comesBackAsExactlyAsPromised) {
  Random random(2);
  for (int run = 0; run < 500; ++run) {
    const TeamBelief said = someBelief(random);
    const auto heard = decodeBelief(encodeBelief(said, "Plumbline", run), "Plumbline", run);
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->number, said.number);
    EXPECT_EQ(heard->localised, said.localised);
    EXPECT_EQ(heard->fallen, said.fallen);
    EXPECT_EQ(heard->role, said.role);
    expectNear(heard->pose.position, said.pose.position, 0.032, 0.043);
    EXPECT_LT(std::abs(normalizeAngle(heard->pose.heading - said.pose.heading)), 0.1);
    EXPECT_NEAR(heard->timeToBall, said.timeToBall, 0.126);
    ASSERT_EQ(heard->ballKnown, said.ballKnown);
    if (said.ballKnown) {
      expectNear(heard->ball, said.ball, 0.032, 0.022);
      expectNear(heard->ballVelocity, said.ballVelocity, 0.501, 0.501);
      EXPECT_GE(heard->ballAge, said.ballAge);
      EXPECT_LE(heard->ballAge, std::max(0.1, 2.5 * said.ballAge));
    }
    ASSERT_EQ(heard->opponents.size(), said.opponents.size());
    for (std::size_t i = 0; i < said.opponents.size(); ++i) {
      EXPECT_EQ(heard->opponents[i].number, said.opponents[i].number);
      expectNear(heard->opponents[i].position, said.opponents[i].position, 0.126, 0.087);
    }
  }
}

TEST(BeliefCodeTest, aBallAtRestStaysAtRest) {
  TeamBelief belief;
  belief.number = 3;
  belief.ballKnown = true;
  const auto heard = decodeBelief(encodeBelief(belief, "A", 1), "A", 1);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->ballVelocity, Vec2(0, 0));
}

TEST(BeliefCodeTest, whatCanBeToldIsMoreThanTheField) {
  const FieldSize field = readFieldFile("config/field.yaml");
  EXPECT_GE(messageHalfLength, field.length / 2 + 0.5);
  EXPECT_GE(messageHalfWidth, field.width / 2 + 0.5);
}

TEST(BeliefCodeTest, anotherTeamAnotherTimeOrAChangedLetterIsNotBelieved) {
  Random random(3);
  int believed = 0;
  for (int run = 0; run < 2000; ++run) {
    std::string text = encodeBelief(someBelief(random), "Plumbline", run);
    if (decodeBelief(text, "Plumbling", run)) ++believed;
    if (decodeBelief(text, "Plumbline", run + 11)) ++believed;
    char& letter = text[random.next() % text.size()];
    letter = letter == 'A' ? 'B' : 'A';
    if (decodeBelief(text, "Plumbline", run)) ++believed;
  }
  EXPECT_LE(believed, 2);  // 6000 tries, each with a chance of 1 in 65536
}

TEST(BeliefCodeTest, nonsenseIsNotBelieved) {
  Random random(4);
  int believed = 0;
  for (int run = 0; run < 5000; ++run) {
    std::string text;
    for (int i = 0; i < 20; ++i) text += static_cast<char>(33 + random.next() % 94);
    if (decodeBelief(text, "Plumbline", run)) ++believed;
  }
  EXPECT_EQ(believed, 0);
}

}  // namespace
