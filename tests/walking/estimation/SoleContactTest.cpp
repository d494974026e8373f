#include "walking/estimation/SoleContact.h"

#include <gtest/gtest.h>

#include "robot/MechanismFile.h"

namespace plumbline::walking {
namespace {

class SoleContactTest : public testing::Test {
protected:
  const Mechanism nao = findMechanism("nao_v5");
  const Mechanism::Foot& foot = nao.feet[0];
  Vec3 sensor(std::size_t k) const {
    return foot.sensors[k].position - nao.links[static_cast<std::size_t>(foot.link)].com;
  }
};

TEST_F(SoleContactTest, thePointIsTheMeanOfTheSensorsByForce) {
  const auto contact = soleContact(nao, foot, {3, 1, 0, 0});
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->force, Vec3(0, 0, 4));
  EXPECT_LT((contact->point - (0.75 * sensor(0) + 0.25 * sensor(1))).norm(), 1e-12);
}

TEST_F(SoleContactTest, belowOneNewtonNothingTouches) {
  EXPECT_FALSE(soleContact(nao, foot, {0.4, 0.59, 0, 0}));
  EXPECT_TRUE(soleContact(nao, foot, {0.4, 0.61, 0, 0}));
}

TEST_F(SoleContactTest, fewerForcesThanSensorsAreAnError) {
  EXPECT_THROW(soleContact(nao, foot, {1, 1}), std::out_of_range);
}

}  // namespace
}  // namespace plumbline::walking
