#include "gap/diagnosis/GapMeter.h"

#include <gtest/gtest.h>

#include "../LegOnItsFoot.h"

namespace plumbline::gap {
namespace {

constexpr double readingNoise = 5e-4;

Trial nominalRun(bool floatingBase) {
  return recorded(nominalPlant(legOnItsFoot()), legTrial(floatingBase), readingNoise, floatingBase ? 7 : 8);
}

/// A run whose hip is off by 0.02 rad for the last part of it.
Trial displaced(Trial trial, double share) {
  const auto from = static_cast<std::size_t>((1 - share) * static_cast<double>(trial.cycles()));
  for (std::size_t k = from; k < trial.cycles(); ++k) trial.signals[0].values[k] += 0.02;
  return trial;
}

struct Judged {
  explicit Judged(std::vector<Trial> trials) : evidence(std::move(trials)), evaluator(leg, evidence) {}
  const Mechanism leg = legOnItsFoot();
  const Evidence evidence;
  const Evaluator evaluator;
};

TEST(GapMeterTest, aLegStandsAsItIsPredicted) {
  const Judged judged({nominalRun(true), nominalRun(false)});
  EXPECT_LT(worstGap(judged.evaluator).size, 0.5);
  EXPECT_LT(gapOnFloatingBase(judged.evaluator), 0.7);
}

TEST(GapMeterTest, onTheFeetAFifthMayGoAstray) {
  const Judged little({displaced(nominalRun(true), 0.1), nominalRun(false)}),
      much({displaced(nominalRun(true), 0.4), nominalRun(false)});
  EXPECT_GT(worstGap(little.evaluator).size, 5);
  EXPECT_LT(gapOnFloatingBase(little.evaluator), 0.7);
  EXPECT_GT(gapOnFloatingBase(much.evaluator), 10);
}

TEST(GapMeterTest, aRobotThatHangsHasNoGapOnItsFeet) {
  const Judged judged({displaced(nominalRun(false), 0.5)});
  EXPECT_EQ(gapOnFloatingBase(judged.evaluator), 0);
  EXPECT_GT(worstGap(judged.evaluator, false).size, 9);
  EXPECT_EQ(worstGap(judged.evaluator, true).size, 0);
}

TEST(GapMeterTest, aJointThatSticksMayLetGoLate) {
  const Trial longRun = recorded(nominalPlant(legOnItsFoot()), legTrial(false, 20), readingNoise, 8);
  Judged little({displaced(longRun, 0.02)}), much({displaced(longRun, 0.2)});
  const Effect *sticks = findEffect("coulomb_friction"), *slides = findEffect("viscous_friction");
  const auto judgedWith = [](Judged& judged, const Effect* effect) {
    Evaluator evaluator(judged.leg, judged.evidence);
    evaluator.setBase({{effect, findPlace(*effect, judged.leg, judged.leg.joints[0].name, ""), 1e-6, 0}});
    return gapOnFixedBase(evaluator);
  };
  EXPECT_NEAR(gapOnFixedBase(little.evaluator), worstGap(little.evaluator, false).size, 1e-12);
  EXPECT_NEAR(judgedWith(little, slides), worstGap(little.evaluator, false).size, 0.01);
  EXPECT_GT(judgedWith(little, slides), 1.5);
  EXPECT_LT(judgedWith(little, sticks), 0.7);
  EXPECT_GT(judgedWith(much, sticks), 3);
}

TEST(GapMeterTest, aJointWithFrictionInTheRobotsFileMayLetGoLate) {
  const Trial longRun = recorded(nominalPlant(legOnItsFoot()), legTrial(false, 20), readingNoise, 8);
  const Judged judged({displaced(longRun, 0.02)});
  Mechanism rough = judged.leg;
  rough.joints[0].friction = 1e-6;
  EXPECT_GT(gapOnFixedBase(judged.evaluator), 1.5);
  EXPECT_LT(gapOnFixedBase(Evaluator(rough, judged.evidence)), 0.7);
}

TEST(GapMeterTest, runsWithAFixedBaseTellWhereTheyAreOffAsWell) {
  const Judged both({displaced(nominalRun(true), 0.4), displaced(nominalRun(false), 0.4)}),
      onlyFloatingBase({displaced(nominalRun(true), 0.4), nominalRun(false)});
  EXPECT_TRUE(fixedBaseDecides(both.evaluator));
  EXPECT_FALSE(fixedBaseDecides(onlyFloatingBase.evaluator));
}

}  // namespace
}  // namespace plumbline::gap
