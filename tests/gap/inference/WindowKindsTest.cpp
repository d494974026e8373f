#include "gap/inference/WindowKinds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../ThreeRecordings.h"

namespace plumbline::gap {

namespace {

WindowKind kindOf(const std::vector<WindowKind>& kinds, const char* id, const char* at) {
  const auto found = std::ranges::find_if(kinds, [&](const WindowKind& kind) {
    return kind.cause.effect->id == std::string(id) && kind.cause.place.at == at;
  });
  return found == kinds.end() ? WindowKind{} : *found;
}

}  // namespace

TEST(WindowKinds, aUnitIsTheMiddleOfTheEffectsStartsAndScalesTheValue) {
  const Mechanism arm = twoJointArm();
  const std::vector<WindowKind> kinds = windowKinds(Groups(recordings({}, 1)), arm);
  const WindowKind friction = kindOf(kinds, "coulomb_friction", "elbow");
  ASSERT_NE(friction.cause.effect, nullptr);
  const double one = causeAt(arm, friction, 1).value;
  EXPECT_GT(one, 0);
  EXPECT_NEAR(causeAt(arm, friction, 2).value, 2 * one, 1e-12);
  EXPECT_EQ(friction.lower, 0);  // friction does not push
  EXPECT_GT(friction.upper, 1);
}

TEST(WindowKinds, whatSensorsOfTheBodyDoIsNotAmongThem) {
  const Mechanism arm = twoJointArm();
  for (const WindowKind& kind : windowKinds(Groups(recordings({}, 1)), arm)) {
    EXPECT_NE(kind.cause.place.site, Site::imu) << describe(kind.cause);
    EXPECT_NE(kind.cause.place.site, Site::foot) << describe(kind.cause);
  }
}

TEST(WindowKinds, causesOfTwoJointsShareAColourAndThoseOfOneDoNot) {
  const Mechanism arm = twoJointArm();
  const std::vector<WindowKind> kinds{{causeOf(arm, "coulomb_friction", "shoulder", 0.1), 1, 0, 9, {0}},
                                      {causeOf(arm, "coulomb_friction", "elbow", 0.1), 1, 0, 9, {1}},
                                      {causeOf(arm, "viscous_friction", "elbow", 0.1), 1, 0, 9, {1}},
                                      {causeOf(arm, "link_mass", "lower", 0.1), 1, 0, 9, {0, 1}},
                                      {causeOf(arm, "viscous_friction", "shoulder", 0.1), 1, 0, 9, {0}}};
  const std::vector<std::vector<std::size_t>> expected{{0, 1}, {2, 4}, {3}};
  EXPECT_EQ(colours(kinds, {0, 1, 2, 3, 4}), expected);
}

}  // namespace plumbline::gap
