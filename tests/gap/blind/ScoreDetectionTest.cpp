#include "gap/blind/ScoreDetection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gap/blind/HandMadeCases.h"

namespace plumbline::gap {
namespace {

TEST(DetectionLimit, AgreesWithFirthsSolutionByHand) {
  // Two severities, ten cases each: the model has a free value at each, and Firth's penalty is then half a
  // success and half a failure more: (2.5 / 11) at 2, (9.5 / 11) at 8.
  std::vector<Detection> trials;
  for (int i = 0; i < 10; ++i) trials.push_back({2, i < 2}), trials.push_back({8, i < 9});
  const double low = std::log(2.5 / 8.5), high = std::log(9.5 / 1.5);
  const double slope = (high - low) / std::log(4.0);
  const double wanted = 2 * std::exp((std::log(0.8 / 0.2) - low) / slope);
  const DetectionLimit limit = detectionLimit(trials, 0.8);
  EXPECT_NEAR(limit.ratio, wanted, 1e-6);
  EXPECT_EQ(limit.count, 20U);
  EXPECT_FALSE(limit.below);
  EXPECT_LE(limit.lower, limit.ratio);
  EXPECT_GE(limit.upper, limit.ratio);
}

TEST(DetectionLimit, SaysNothingBeyondWhatWasTried) {
  std::vector<Detection> all, none;
  for (int i = 0; i < 40; ++i) all.push_back({3.0 + i, true}), none.push_back({3.0 + i, false});
  const DetectionLimit found = detectionLimit(all), missed = detectionLimit(none);
  EXPECT_TRUE(found.below);
  EXPECT_DOUBLE_EQ(found.ratio, 3);
  EXPECT_TRUE(std::isinf(missed.ratio));
  EXPECT_TRUE(std::isinf(missed.upper));
  EXPECT_EQ(detectionLimit({}).count, 0U);
}

TEST(DetectionLimit, StrongOnesThatAreMissedDoNotHideThatWeakOnesAreFound) {
  std::vector<Detection> most, half;
  for (int i = 0; i < 40; ++i) most.push_back({3.0 + i, i < 39}), half.push_back({3.0 + i, i < 20});
  const DetectionLimit limit = detectionLimit(most);
  EXPECT_TRUE(limit.below);
  EXPECT_DOUBLE_EQ(limit.ratio, 3);
  EXPECT_TRUE(std::isinf(detectionLimit(half).ratio));
}

TEST(DetectionLimit, EqualSeveritiesAreNoTrouble) {
  const std::vector<Detection> trials(30, {5, true});
  const DetectionLimit limit = detectionLimit(trials);
  EXPECT_TRUE(limit.below);
  EXPECT_DOUBLE_EQ(limit.ratio, 5);
}

BlindEffect play(const char* at) { return {"backlash", at, "", 1, {}}; }

TEST(EffectScores, CountsByHand) {
  BlindSet set;
  const BlindEffect band{"dead_band", "Knee", "", 1, {}};
  set.cases = {caseOf(BlindKind::single, {play("Knee")}, 9),
               caseOf(BlindKind::hard, {play("LHip")}, 5),
               caseOf(BlindKind::single, {play("Knee")}, 4),
               caseOf(BlindKind::single, {play("Knee")}, 2),
               caseOf(BlindKind::mixture, {band, play("LHip")}),
               caseOf(BlindKind::single, {band}, 7),
               caseOf(BlindKind::none, {}),
               caseOf(BlindKind::outside, {{"ripple", "Knee", "", 1, {}}})};
  const BlindAnswer knee = answer("effect", {named("backlash", "Knee", 1, 1)}),
                    hip = answer("effect", {named("backlash", "RHip", 1, 1)});
  const std::vector<BlindAnswer> answers = {
      knee,           hip, answer("unknown", {named("backlash", "Knee", 1, 1)}), knee, hip, answer("none"),
      answer("none"), knee};
  const std::vector<EffectScore> scores = effectScores(set, answers, twoHips());
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].effect, "backlash");
  EXPECT_EQ(scores[0].singles, 4U);
  EXPECT_EQ(scores[0].found, 3U);
  EXPECT_EQ(scores[0].allFoundFrom, 5);
  EXPECT_EQ(scores[0].weakestFound, 2);
  EXPECT_EQ(scores[0].strongestMissed, 4);
  EXPECT_EQ(scores[0].ofMixtures, 1U);
  EXPECT_EQ(scores[0].foundInMixtures, 1U);
  EXPECT_EQ(scores[1].effect, "dead_band");
  EXPECT_EQ(scores[1].singles, 1U);
  EXPECT_EQ(scores[1].found, 0U);
  EXPECT_FALSE(scores[1].allFoundFrom.has_value());
  EXPECT_EQ(scores[1].strongestMissed, 7);
  EXPECT_EQ(scores[1].foundInMixtures, 0U);

  // Seen is another question than named: unknown has seen something.
  std::size_t seen = 0, found = 0;
  for (const Detection& d : detectionsOf(set, answers, twoHips(), true)) seen += d.found;
  for (const Detection& d : detectionsOf(set, answers, twoHips(), false)) found += d.found;
  EXPECT_EQ(seen, 4U);
  EXPECT_EQ(found, 3U);
}

}  // namespace
}  // namespace plumbline::gap
