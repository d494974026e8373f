#include "gap/inference/CauseKinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

namespace {

CauseKind kindOf(const std::vector<CauseKind>& kinds, const char* id, const char* at) {
  const auto found = std::ranges::find_if(kinds, [&](const CauseKind& kind) {
    return kind.cause.effect->id == std::string(id) && kind.cause.place.at == at;
  });
  return found == kinds.end() ? CauseKind{} : *found;
}

}  // namespace

TEST(CauseKinds, aUnitIsTheMiddleOfTheEffectsStartsAndScalesTheValue) {
  const Mechanism arm = twoJointArm();
  const std::vector<CauseKind> kinds = windowKinds(Groups(recordings({}, 1)), arm);
  const CauseKind friction = kindOf(kinds, "coulomb_friction", "elbow");
  ASSERT_NE(friction.cause.effect, nullptr);
  const double one = causeAt(arm, friction, 1).value;
  EXPECT_GT(one, 0);
  EXPECT_NEAR(causeAt(arm, friction, 2).value, 2 * one, 1e-12);
  EXPECT_EQ(friction.lower, 0);  // friction does not push
  EXPECT_GT(friction.upper, 1);
}

TEST(CauseKinds, whatSensorsOfTheBodyDoIsNotAmongThem) {
  const Mechanism arm = twoJointArm();
  for (const CauseKind& kind : windowKinds(Groups(recordings({}, 1)), arm)) {
    EXPECT_NE(kind.cause.place.site, Site::imu) << describe(kind.cause);
    EXPECT_NE(kind.cause.place.site, Site::foot) << describe(kind.cause);
  }
}

TEST(CauseKinds, allKindsHoldThoseOfTheBodysSensorsWhereTheseAreMeasured) {
  Mechanism arm = twoJointArm();
  arm.hasImu = true;
  std::vector<Trial> trials = recordings({}, 1);
  for (Trial& trial : trials) {
    Signal gyro;
    gyro.name = "gyro.x";
    gyro.kind = SignalKind::gyro;
    gyro.values.assign(trial.cycles(), 0);
    for (std::size_t k = 0; k < trial.cycles(); ++k) gyro.values[k] = 1e-3 * std::sin(static_cast<double>(k));
    trial.signals.push_back(gyro);
  }
  const std::vector<CauseKind> kinds = causeKinds(Groups(trials), arm);
  std::size_t sensors = 0;
  for (const CauseKind& kind : kinds)
    if (kind.cause.place.site == Site::imu) {
      ++sensors;
      EXPECT_EQ(kind.joints, std::vector<int>{-1}) << describe(kind.cause);
    }
  EXPECT_GT(sensors, 0U);
}

TEST(CauseKinds, causesOfTwoJointsShareAColourAndThoseOfOneDoNot) {
  const Mechanism arm = twoJointArm();
  const std::vector<CauseKind> kinds{{causeOf(arm, "coulomb_friction", "shoulder", 0.1), 1, 0, 9, {0}},
                                     {causeOf(arm, "coulomb_friction", "elbow", 0.1), 1, 0, 9, {1}},
                                     {causeOf(arm, "viscous_friction", "elbow", 0.1), 1, 0, 9, {1}},
                                     {causeOf(arm, "link_mass", "lower", 0.1), 1, 0, 9, {0, 1}},
                                     {causeOf(arm, "viscous_friction", "shoulder", 0.1), 1, 0, 9, {0}}};
  const std::vector<std::vector<std::size_t>> expected{{0, 1}, {2, 4}, {3}};
  EXPECT_EQ(colours(kinds, {0, 1, 2, 3, 4}), expected);
}

TEST(CauseKinds, ofAConfiguredSettingTheUnitIsItsStrengthAndItsMaskHasAPrice) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}, 1));
  Cause limit = causeOf(arm, "acceleration_limit", "elbow", 20);
  EXPECT_EQ(configuredKind(groups, arm, limit).price, 0);
  limit.inactiveIn = {"run1"};
  const CauseKind kind = configuredKind(groups, arm, limit);
  EXPECT_NEAR(kind.price, std::log(4 * 3), 1e-12);
  EXPECT_NEAR(causeAt(arm, kind, 1).value, 20, 1e-9);
  EXPECT_EQ(causeAt(arm, kind, 0.5).inactiveIn, limit.inactiveIn);
  EXPECT_EQ(kind.joints, std::vector<int>{1});
}

}  // namespace plumbline::gap
