#include "walking/estimation/ModelFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "math/Random.h"
#include "walking/estimation/BackgroundFit.h"
#include "walking/estimation/FitSafety.h"

namespace plumbline::walking {
namespace {

/// Steps of a robot that moves as the pendulum with these parameters, seen with this noise [m, 10 times as
/// much m/s].
std::vector<ObservedStep> stepsOf(const ModelParameters& truth, int count, double noise,
                                  std::uint64_t seed = 1) {
  Random random(seed);
  std::vector<ObservedStep> steps;
  for (int i = 0; i < count; ++i) {
    ObservedStep step;
    step.begin.support = i % 2 == 0 ? Support::left : Support::right;
    const double side = i % 2 == 0 ? 1 : -1;
    step.begin.foot[i % 2] = Pose2(random.uniform(0, 0.03), side * random.uniform(0.045, 0.055));
    step.begin.velocity = Vec2(random.uniform(-0.2, 0.2), side * random.uniform(0.15, 0.25));
    const LinearInvertedPendulum robot = step.pendulum.with(truth);
    for (double time = 0.02; time < 0.21; time += 0.02) {
      const WalkState state = step.predicted(robot, time);
      const Vec2 disturbance(random.gaussian(), random.gaussian());
      step.samples.push_back({time, Vec2(state.supportFoot().position + noise * disturbance),
                              Vec2(state.velocity - 10 * noise * disturbance)});
    }
    steps.push_back(step);
  }
  return steps;
}

ModelParameters biased() {
  ModelParameters truth;
  truth.massOffsetX = 0.006;
  truth.massOffsetZy = 0.03;
  truth.footFactorY = 1.06;
  return truth;
}

TEST(ModelFit, predictionErrorIsZeroForTheTruthAndGrowsWithTheBias) {
  const auto steps = stepsOf(biased(), 12, 0);
  EXPECT_NEAR(predictionError(steps, biased()), 0, 1e-20);
  ModelParameters half = biased();
  half.massOffsetX /= 2;
  EXPECT_GT(predictionError(steps, half), 0.01);
  EXPECT_GT(predictionError(steps, {}), predictionError(steps, half));
}

TEST(ModelFit, removesABias) {
  const auto steps = stepsOf(biased(), 30, 0.0005);
  const ModelFitResult result = fitModel(steps, {});
  EXPECT_TRUE(result.accepted);
  EXPECT_EQ(result.best.size(), 60u);
  // Steps of another day: at least nine tenths of the squared error are gone.
  const auto others = stepsOf(biased(), 30, 0.0005, 99);
  EXPECT_LT(predictionError(others, result.parameters), 0.1 * predictionError(others, {}));
  EXPECT_LT(result.leftOutAfter, 0.1 * result.leftOutBefore);
}

TEST(ModelFit, whatOnlyPredictsIsNotHeldToTheWalk) {
  // A robot whose mass is 2 cm off and that is braked by less than the pendulum says: planned with, another
  // walk.
  ModelParameters slow;
  slow.timeFactor = 0.85;
  slow.massOffsetX = 0.02;
  const auto steps = stepsOf(slow, 30, 0.0005), others = stepsOf(slow, 30, 0.0005, 99);
  const ModelFitResult result = fitModel(steps, {});
  EXPECT_TRUE(result.predicts);
  EXPECT_LT(predictionError(others, result.prediction), 0.02 * predictionError(others, {}));
  EXPECT_GT(FitSafety(steps).change(result.prediction), 1);
  EXPECT_LE(FitSafety(steps).change(result.parameters), 1);
  EXPECT_GT(predictionError(others, result.parameters), 2 * predictionError(others, result.prediction));
  EXPECT_EQ(result.bestPrediction.size(), 60u);
  const ModelFitResult alone = fitModel(steps, {}, {.plan = false});
  EXPECT_EQ(alone.prediction.values(), result.prediction.values());
  EXPECT_FALSE(alone.accepted);
  EXPECT_TRUE(alone.best.empty());
  // In use already, it stays unless there is a better one.
  const ModelFitResult again = fitModel(steps, {}, {.generations = 1, .prediction = result.prediction});
  EXPECT_FALSE(again.predicts);
  EXPECT_EQ(again.prediction.values(), result.prediction.values());
}

TEST(ModelFit, aRobotFartherOffThanAnyThatIsLookedForEndsAtTheBound) {
  // Masses 4 cm aside or 10 cm lower, 0.2 m/s of speed, feet and time at 0.6 of what the pendulum says.
  using P = ModelParameters;
  struct Farthest {
    double P::*value;
    double bound;
  };
  for (const Farthest& of : {Farthest{&P::massOffsetX, -0.04},
                             {&P::massOffsetX, 0.04},
                             {&P::massOffsetY, -0.04},
                             {&P::massOffsetY, 0.04},
                             {&P::massOffsetZx, -0.1},
                             {&P::massOffsetZy, -0.1},
                             {&P::velocityOffsetX, -0.2},
                             {&P::velocityOffsetX, 0.2},
                             {&P::velocityOffsetY, -0.2},
                             {&P::velocityOffsetY, 0.2},
                             {&P::footFactorX, 0.6},
                             {&P::footFactorY, 0.6},
                             {&P::footFactor, 0.6},
                             {&P::timeFactor, 0.6}}) {
    ModelParameters truth, near;
    const double neutral = truth.*of.value;
    truth.*of.value += 1.5 * (of.bound - neutral);
    near.*of.value += 0.9 * (of.bound - neutral);
    const ModelFitResult result = fitModel(stepsOf(truth, 30, 0), {}, {.prediction = near, .plan = false});
    EXPECT_NEAR(result.prediction.*of.value, of.bound, 0.01 * std::abs(of.bound));
  }
}

// Steps of one kind of walking say little of another one, so a fit for planning goes two typical deviations
// at most. That is 4 cm of the mass's height, and enough for this robot.
TEST(ModelFit, aFitForPlanningFindsAMassThreeCentimetresHigher) {
  ModelParameters truth;
  truth.massOffsetZx = 0.1;  // the price of changes leaves a third of it
  const ModelFitResult result = fitModel(stepsOf(truth, 30, 0), {});
  EXPECT_TRUE(result.accepted);
  EXPECT_LE(result.parameters.massOffsetZx, 0.04 + 1e-12);
  EXPECT_GT(result.parameters.massOffsetZx, 0.03);
}

TEST(ModelFit, doesNoHarmWhereThereIsNone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto steps = stepsOf({}, 30, 0.002, seed);
    const ModelFitResult result = fitModel(steps, {}, {.seed = seed});
    const auto others = stepsOf({}, 300, 0, seed + 50);
    EXPECT_LT(predictionError(others, result.parameters), 0.05) << "a twentieth of 5 mm squared";
    EXPECT_LT(predictionError(others, result.prediction), 0.05);
    if (!result.accepted) {
      EXPECT_EQ(result.parameters.values(), ModelParameters{}.values());
    }
  }
}

TEST(ModelFit, neverTakesWhatPredictsLeftOutStepsWorse) {
  // Every third step, which is left out of the fit, is of another robot.
  auto steps = stepsOf(biased(), 30, 0);
  const auto plain = stepsOf({}, 30, 0);
  for (std::size_t i = 2; i < steps.size(); i += 3) steps[i] = plain[i];
  const ModelFitResult result = fitModel(steps, {});
  EXPECT_LT(result.after, result.before);
  EXPECT_GT(result.leftOutAfter, result.leftOutBefore);
  EXPECT_FALSE(result.accepted);
  EXPECT_EQ(result.parameters.values(), ModelParameters{}.values());
  EXPECT_GT(result.predictionLeftOutAfter, result.predictionLeftOutBefore);
  EXPECT_FALSE(result.predicts);
  EXPECT_EQ(result.prediction.values(), ModelParameters{}.values());
}

TEST(FitSafety, tellsASetThatWalksElsewhereFromOneThatDoesNot) {
  const FitSafety safety(stepsOf({}, 12, 0));
  EXPECT_NEAR(safety.change({}), 0, 1e-9);
  ModelParameters taller;
  taller.massOffsetZy = 0.01;
  EXPECT_LT(safety.change(taller), 1);
  // Found in steps at 0.2 m/s, which it predicts well; on the spot it walks backward.
  ModelParameters open;
  open.massOffsetX = 0.011;
  open.velocityOffsetX = 0.03;
  open.footFactorX = 0.95;
  open.footFactor = 0.93;
  EXPECT_GT(safety.change(open), 1);
}

TEST(BackgroundFit, whatPredictsWorseOnProbationIsRolledBack) {
  BackgroundFit background({.steps = 30, .duration = 1, .wait = true, .probation = 10});
  for (const ObservedStep& step : stepsOf(biased(), 30, 0.0005)) background.add(step);
  std::optional<ModelFitResult> result;
  while (!result) result = background.pass(0.02, {});
  ASSERT_TRUE(result->accepted);
  ASSERT_TRUE(background.onProbation());
  // The robot turns out to be another one.
  ModelParameters another;
  another.massOffsetX = -0.02;
  for (const ObservedStep& step : stepsOf(another, 10, 0.0005, 5)) background.add(step);
  const auto back = background.pass(0.02, result->parameters, result->prediction);
  ASSERT_TRUE(back.has_value());
  EXPECT_TRUE(back->rolledBack);
  EXPECT_EQ(back->parameters.values(), ModelParameters{}.values());
  EXPECT_EQ(back->prediction.values(), ModelParameters{}.values());
  EXPECT_FALSE(background.onProbation());
}

TEST(BackgroundFit, onlyTheSetThatGotWorseIsRolledBack) {
  BackgroundFit background({.steps = 30, .duration = 1, .wait = true, .probation = 10});
  for (const ObservedStep& step : stepsOf(biased(), 30, 0.0005)) background.add(step);
  std::optional<ModelFitResult> result;
  while (!result) result = background.pass(0.02, {});
  ASSERT_TRUE(result->accepted && result->predicts);
  for (const ObservedStep& step : stepsOf(biased(), 10, 0.0005, 5)) background.add(step);
  // What is said to be in use for predictions is of another robot.
  ModelParameters another;
  another.massOffsetX = -0.02;
  const auto back = background.pass(0.02, result->parameters, another);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->parameters.values(), result->parameters.values());
  EXPECT_EQ(back->prediction.values(), ModelParameters{}.values());
}

TEST(BackgroundFit, aFallOnProbationRollsBackAndATestThatIsPassedDoesNot) {
  for (const bool falls : {true, false}) {
    BackgroundFit background({.steps = 30, .duration = 1, .wait = true, .probation = 10});
    for (const ObservedStep& step : stepsOf(biased(), 30, 0.0005)) background.add(step);
    std::optional<ModelFitResult> result;
    while (!result) result = background.pass(0.02, {});
    if (falls) background.fell();
    for (const ObservedStep& step : stepsOf(biased(), 10, 0.0005, 5)) background.add(step);
    EXPECT_EQ(background.pass(0.02, result->parameters, result->prediction).has_value(), falls);
    EXPECT_FALSE(background.onProbation());
  }
}

TEST(ModelFit, dependsOnItsArgumentsAlone) {
  const auto steps = stepsOf(biased(), 15, 0.001);
  const ModelFitOptions options{.generations = 15, .seed = 4};
  EXPECT_EQ(fitModel(steps, {}, options).best, fitModel(steps, {}, options).best);
  EXPECT_EQ(fitModel({}, biased()).parameters.values(), biased().values());
}

TEST(BackgroundFit, handsOverWhenDueWhatTheFitFinds) {
  BackgroundFit background(
      {.steps = 30, .duration = 20, .wait = true, .fit = {.generations = 20, .seed = 3}});
  const auto steps = stepsOf(biased(), 30, 0.0005);
  for (std::size_t i = 0; i < 29; ++i) background.add(steps[i]);
  EXPECT_FALSE(background.pass(0.02, {}).has_value());
  EXPECT_FALSE(background.busy());
  background.add(steps[29]);
  int cycles = 1;
  std::optional<ModelFitResult> result;
  while (!(result = background.pass(0.02, {})) && cycles < 2000) ++cycles;
  EXPECT_NEAR(cycles, 1000, 1) << "20 s of walking";
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->accepted);
  EXPECT_EQ(result->parameters.values(),
            fitModel(steps, {}, {.generations = 20, .seed = 3}).parameters.values());
  // It begins anew with new steps.
  EXPECT_FALSE(background.pass(0.02, result->parameters).has_value());
  EXPECT_FALSE(background.busy());
}

TEST(BackgroundFit, keepsTheNewestStepsOnly) {
  BackgroundFit background(
      {.steps = 10, .maxSteps = 10, .duration = 1, .wait = true, .fit = {.generations = 3}});
  const auto old = stepsOf({}, 20, 0), steps = stepsOf(biased(), 10, 0);
  for (const ObservedStep& step : old) background.add(step);
  for (const ObservedStep& step : steps) background.add(step);
  background.pass(0.02, {});
  const auto result = background.pass(1, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->best, fitModel(steps, {}, {.generations = 3}).best);
}

TEST(BackgroundFit, endsAtOnceInTheMiddleOfAFit) {
  const std::clock_t before = std::clock();
  {
    BackgroundFit background({.steps = 30, .cpuShare = 0.01, .fit = {.generations = 1000000}});
    for (const ObservedStep& step : stepsOf(biased(), 30, 0)) background.add(step);
    background.pass(0.02, {});
  }
  // Of a million generations, which take days; the whole process.
  EXPECT_LT(std::clock() - before, 5 * CLOCKS_PER_SEC);
}

}  // namespace
}  // namespace plumbline::walking
