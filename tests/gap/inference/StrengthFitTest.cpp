#include "gap/inference/StrengthFit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "../ThreeRecordings.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

namespace {

struct StrengthFitTest : testing::Test {
  void record(const Explanation& truth) {
    groups.emplace(recordings(truth));
    replayer.emplace(arm, *groups, 1);
    fitter.emplace(*replayer);
  }
  std::size_t kind(const char* id, const char* at) const {
    const auto& kinds = fitter->kinds();
    return static_cast<std::size_t>(std::ranges::find_if(kinds,
                                                         [&](const CauseKind& of) {
                                                           return of.cause.effect->id == std::string(id) &&
                                                                  of.cause.place.at == at;
                                                         }) -
                                    kinds.begin());
  }
  StrengthSet setOf(std::vector<std::size_t> kinds, double x) const {
    std::ranges::sort(kinds);
    const auto n = static_cast<Eigen::Index>(kinds.size());
    return {kinds, Eigen::VectorXd::Constant(n, x)};
  }

  Mechanism arm = twoJointArm();
  std::optional<Groups> groups;
  std::optional<WindowReplayer> replayer;
  std::optional<StrengthFitter> fitter;
};

}  // namespace

TEST_F(StrengthFitTest, findsBothValues) {
  record({causeOf(arm, "coulomb_friction", "shoulder", 0.12), causeOf(arm, "servo_gain", "elbow", 0.7)});
  const std::size_t friction = kind("coulomb_friction", "shoulder"), gain = kind("servo_gain", "elbow");
  const StrengthSet start = setOf({friction, gain}, 0.5), set = fitter->refine(start, 10);
  ASSERT_EQ(set.kinds, start.kinds);
  for (const Cause& cause : fitter->causesOf(set)) {
    const bool isGain = cause.effect->id == std::string("servo_gain");
    EXPECT_NEAR(cause.value, isGain ? 0.7 : 0.12, 0.01);
  }
  EXPECT_GT(fitter->density(set), fitter->density(start));
}

TEST_F(StrengthFitTest, aDelayThatDerivativesMissIsFoundStepByStep) {
  record({causeOf(arm, "command_delay", "elbow", 0.013)});
  const StrengthSet set = fitter->refine(setOf({kind("command_delay", "elbow")}, 0.3), 10);
  ASSERT_EQ(set.kinds.size(), 1U);
  EXPECT_NEAR(fitter->causesOf(set)[0].value, 0.013, 5e-4);
}

TEST_F(StrengthFitTest, aCauseThatIsNotThereVanishesOrStaysSmall) {
  record({});
  const StrengthSet set = fitter->refine(setOf({kind("coulomb_friction", "shoulder")}, 1), 10);
  EXPECT_LT(set.at(kind("coulomb_friction", "shoulder")), 0.1);
}

TEST_F(StrengthFitTest, whatAllJointsShareAndWhatOneHasMoreCanBeTogether) {
  record({});
  const std::size_t one = kind("servo_gain", "elbow"), all = kind("servo_gain", "*"),
                    other = kind("servo_gain", "shoulder");
  ASSERT_LT(all, fitter->kinds().size());
  EXPECT_FALSE(fitter->exclude(one, all));
  EXPECT_FALSE(fitter->exclude(one, other));
  EXPECT_FALSE(fitter->exclude(one, kind("coulomb_friction", "elbow")));
}

TEST_F(StrengthFitTest, whatIsNotFeltHasNoSlope) {
  record({});
  const std::size_t friction = kind("coulomb_friction", "elbow");
  const LinearResiduals linear = fitter->linearise({}, {friction});
  // One kind alone was asked for: it is all that can be proposed.
  for (const std::size_t proposed : linear.proposals({}, 9)) EXPECT_EQ(proposed, friction);
}

TEST(StrengthSets, aKindIsAddedInOrderAndTakenOut) {
  const StrengthSet set{{1, 4}, Eigen::Vector2d(0.5, 2)};
  const StrengthSet three = with(set, 2);
  EXPECT_EQ(three.kinds, (std::vector<std::size_t>{1, 2, 4}));
  EXPECT_EQ(three.x, Eigen::Vector3d(0.5, 0, 2));
  const StrengthSet again = without(three, 2);
  EXPECT_EQ(again.kinds, set.kinds);
  EXPECT_EQ(again.x, set.x);
}

TEST_F(StrengthFitTest, aSetOfCausesHasTheirKindsAndStrengthsThoseConfiguredFirst) {
  record({});
  Cause limit = causeOf(arm, "acceleration_limit", "elbow", 20);
  const StrengthFitter configured(*replayer, {configuredKind(*groups, arm, limit)});
  const Explanation causes{limit, causeOf(arm, "servo_gain", "shoulder", 0.7)};
  const StrengthSet set = configured.setOf(causes);
  ASSERT_EQ(set.kinds.size(), 2U);
  EXPECT_EQ(set.kinds.back(), configured.kinds().size() - 1);
  EXPECT_NEAR(set.x[1], 1, 1e-12);
  for (const Cause& cause : configured.causesOf(set))
    EXPECT_NEAR(cause.value, cause.effect == limit.effect ? 20 : 0.7, 1e-9);
  EXPECT_TRUE(configured.exclude(set.kinds.back(), kind("acceleration_limit", "elbow")));
  limit.inactiveIn = {"run1"};
  EXPECT_TRUE(configured.setOf({limit}).kinds.empty()) << "no kind has that mask";
}

}  // namespace plumbline::gap
