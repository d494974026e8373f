#include "gap/blind/BlindScore.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gap/blind/Draw.h"
#include "gap/blind/HandMadeCases.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

TEST(BlindScore, CountsByHand) {
  const BlindEffect friction{"coulomb_friction", "LHip", "", 0.2, {}};
  const BlindEffect gain{"servo_gain", "Knee", "", 0.8, {}};
  BlindSet set;
  set.cases = {caseOf(BlindKind::none, {}, 0),
               caseOf(BlindKind::none, {}, 0),
               caseOf(BlindKind::single, {friction}),
               caseOf(BlindKind::hard, {gain}),
               caseOf(BlindKind::single, {gain}, 2),
               caseOf(BlindKind::mixture, {friction, gain}),
               caseOf(BlindKind::outside, {{"gear_ripple", "Knee", "", 1, {}}}),
               caseOf(BlindKind::outside, {{"gear_ripple", "Knee", "", 1, {}}})};
  const std::vector<BlindAnswer> answers = {
      answer("none"), answer("unknown"),
      // The other joint of the same motor; 10 % off.
      answer("effect", {named("coulomb_friction", "RHip", 0.22, 0.9)}, 0.9),
      // Right among the rivals.
      answer("effect", {named("servo_damping", "Knee", 2, 0.6, {{"servo_gain", "Knee", "", 0.8, 0.3}})}, 0.5),
      answer("none"),
      // One of two, and one too many.
      answer("effect", {named("servo_gain", "Knee", 0.76, 0.8), named("backlash", "Knee", 1, 0.5)}, 1.2),
      answer("unknown"), answer("effect", {named("backlash", "Knee", 1, 0.7)})};
  const BlindScore score = scoreBlind(set, answers, twoHips());
  EXPECT_DOUBLE_EQ(score.figure("top1").value, 0.5);
  EXPECT_EQ(score.figure("top1").count, 2U);  // the one below the least ratio stays out
  EXPECT_DOUBLE_EQ(score.figure("top3").value, 1);
  EXPECT_DOUBLE_EQ(score.figure("place").value, 1);
  EXPECT_DOUBLE_EQ(score.figure("hard").value, 0);
  EXPECT_DOUBLE_EQ(score.figure("false_alarms").value, 0.5);
  EXPECT_DOUBLE_EQ(score.figure("missed").value, 0);
  EXPECT_DOUBLE_EQ(score.figure("unknown_found").value, 0.5);
  EXPECT_DOUBLE_EQ(score.figure("false_unknown").value, 0.2);
  EXPECT_DOUBLE_EQ(score.figure("mixture_f1").value, 0.5);
  // 0.02 of 0.2, and 0.04 of the 0.2 that the gain is off nominal.
  EXPECT_NEAR(score.figure("parameter_error").value, 0.15, 1e-12);
  EXPECT_NEAR(score.figure("gap_closed").value, (0.9 + 0.5 + 1) / 3, 1e-12);
  // 0.9 right, 0.6 wrong, 0.8 right, 0.5 wrong, 0.7 wrong: each in a bin of its own.
  EXPECT_NEAR(score.figure("ece").value, (0.1 + 0.6 + 0.2 + 0.5 + 0.7) / 5, 1e-12);
  EXPECT_EQ(score.bySeverity[0].count, 1U);
  EXPECT_EQ(score.bySeverity[2].what, "5 to 10");
  EXPECT_EQ(score.bySeverity[2].count, 2U);
  EXPECT_EQ(score.missing, 0U);
}

TEST(BlindScore, CasesCountByHowMuchTheyShow) {
  BlindSet set;
  for (const double ratio : {2.9, 3.1, 3.8, 4.0, 4.9, 5.1, 9.0, 11.0, 19.0, 21.0, 49.0, 51.0})
    set.cases.push_back(caseOf(BlindKind::single, {{"backlash", "Knee", "", 1, {}}}, ratio));
  const BlindScore score =
      scoreBlind(set, std::vector<BlindAnswer>(set.cases.size(), answer("none")), twoHips());
  const std::pair<const char*, std::size_t> wanted[] = {{"0 to 3", 1},   {"3 to 5", 4},   {"5 to 10", 2},
                                                        {"10 to 20", 2}, {"20 to 50", 2}, {"50 and more", 1}};
  ASSERT_EQ(score.bySeverity.size(), std::size(wanted));
  for (std::size_t i = 0; i < std::size(wanted); ++i) {
    EXPECT_EQ(score.bySeverity[i].what, wanted[i].first);
    EXPECT_EQ(score.bySeverity[i].count, wanted[i].second) << wanted[i].first;
  }
}

TEST(BlindScore, NoAnswerIsAWrongAnswer) {
  BlindSet set;
  set.cases = {caseOf(BlindKind::none, {}, 0), caseOf(BlindKind::single, {{"backlash", "Knee", "", 1, {}}})};
  const BlindScore score = scoreBlind(set, {answer(""), answer("")}, twoHips());
  EXPECT_EQ(score.missing, 2U);
  EXPECT_DOUBLE_EQ(score.figure("false_alarms").value, 1);
  EXPECT_DOUBLE_EQ(score.figure("top1").value, 0);
}

TEST(BlindScore, UnknownIsWrongEvenWhereItsNearestExplanationIsRight) {
  BlindSet set;
  set.cases = {
      caseOf(BlindKind::single, {{"backlash", "Knee", "", 1, {}}}),
      caseOf(BlindKind::single, {{"dead_band", "Knee", "", 1, {}}}),
      caseOf(BlindKind::mixture, {{"backlash", "Knee", "", 1, {}}, {"dead_band", "LHip", "", 1, {}}})};
  const BlindScore score =
      scoreBlind(set,
                 {answer("unknown", {named("backlash", "Knee", 1, 0.4)}),
                  answer("unknown", {named("backlash", "Knee", 1, 0.4)}),
                  answer("unknown", {named("backlash", "Knee", 1, 0.4), named("dead_band", "LHip", 1, 0.4)})},
                 twoHips());
  for (const char* id : {"top1", "top3", "place", "mixture_f1"})
    EXPECT_DOUBLE_EQ(score.figure(id).value, 0) << id;
  EXPECT_DOUBLE_EQ(score.figure("false_unknown").value, 1);
  EXPECT_DOUBLE_EQ(score.figure("nearest_right").value, 0.5);
  EXPECT_EQ(score.figure("nearest_right").count, 2U);
  EXPECT_EQ(score.figure("parameter_error").count, 0U);
  EXPECT_EQ(score.figure("ece").count, 0U);
}

TEST(BlindScore, OutsideTheLibraryOnlyUnknownIsRight) {
  BlindSet set;
  const std::vector<BlindEffect> ripple = {{"gear_ripple", "Knee", "", 1, {}}};
  set.cases = {caseOf(BlindKind::outside, ripple), caseOf(BlindKind::outside, ripple),
               caseOf(BlindKind::outside, ripple), caseOf(BlindKind::outside, ripple),
               caseOf(BlindKind::outside, ripple, 2.9)};
  // The effect named is right to the letter, and still no answer that the library can give.
  const BlindScore score =
      scoreBlind(set,
                 {answer("unknown"), answer("none"), answer(""),
                  answer("effect", {named("gear_ripple", "Knee", 1, 0.8)}), answer("unknown")},
                 twoHips());
  EXPECT_DOUBLE_EQ(score.figure("unknown_found").value, 0.25);
  EXPECT_EQ(score.figure("unknown_found").count, 4U);  // the weak one stays out
  EXPECT_EQ(score.figure("false_unknown").count, 0U);
  EXPECT_NEAR(score.figure("ece").value, 0.8, 1e-12);
  EXPECT_EQ(score.figure("missed").count, 0U);
  EXPECT_EQ(score.figure("gap_closed").count, 0U);
}

TEST(BlindScore, ErrorIsMeasuredFromNominalAndOfLimitsByTheirValue) {
  BlindSet set;
  set.cases = {caseOf(BlindKind::single, {{"supply_voltage", "*", "", 0.8, {}}}),
               caseOf(BlindKind::single, {{"acceleration_limit", "Knee", "", 20, {}}}),
               caseOf(BlindKind::single, {{"bias_force", "Knee", "", -0.1, {}}})};
  const BlindScore score =
      scoreBlind(set,
                 {answer("effect", {named("supply_voltage", "*", 0.82, 1)}),       // 0.02 of 0.2
                  answer("effect", {named("acceleration_limit", "Knee", 25, 1)}),  // 5 of 20
                  answer("effect", {named("bias_force", "Knee", 0.1, 1)})},        // the wrong way
                 twoHips());
  EXPECT_NEAR(score.figure("parameter_error").value, 0.25, 1e-12);
  EXPECT_EQ(score.figure("parameter_error").count, 3U);
}

TEST(BlindScore, CountsEffectsTooMany) {
  BlindSet set;
  const std::vector<BlindEffect> play = {{"backlash", "Knee", "", 1, {}}};
  set.cases = {caseOf(BlindKind::single, play), caseOf(BlindKind::single, play)};
  const BlindScore score =
      scoreBlind(set,
                 {answer("effect", {named("backlash", "Knee", 1, 0.9)}),
                  answer("effect", {named("backlash", "Knee", 1, 0.9), named("dead_band", "Knee", 1, 0.9)})},
                 twoHips());
  EXPECT_DOUBLE_EQ(score.figure("top1").value, 1);
  EXPECT_DOUBLE_EQ(score.figure("extra").value, 0.5);
}

TEST(BlindScore, WilsonsInterval) {
  const Figure nine = share("", "", 9, 10);
  EXPECT_NEAR(nine.lower, 0.5958, 1e-4);
  EXPECT_NEAR(nine.upper, 0.9821, 1e-4);
  const Figure none = share("", "", 0, 40);
  EXPECT_DOUBLE_EQ(none.lower, 0);
  EXPECT_NEAR(none.upper, 0.0876, 1e-4);
}

TEST(BlindScore, CalibrationByBins) {
  const std::vector<CalibrationBin> bins = calibrationBins({{0.21, true}, {0.29, false}, {0.31, true}});
  ASSERT_EQ(bins.size(), 10U);
  EXPECT_EQ(bins[2].right.count, 2U);
  EXPECT_DOUBLE_EQ(bins[2].stated, 0.25);
  EXPECT_EQ(bins[3].right.count, 1U);
  // Two in one bin with mean 0.95 and one of them right: |0.95 - 0.5|; one at 0.15, wrong.
  EXPECT_NEAR(calibrationError({{0.93, true}, {0.97, false}, {0.15, false}}), (0.9 + 0.15) / 3, 1e-12);
  EXPECT_DOUBLE_EQ(calibrationError({{1, true}, {0, false}}), 0);
}

TEST(BlindScore, BinsSayWhatIsStatedAndWhatIsRight) {
  const auto bins = calibrationBins({{0.93, true}, {0.97, false}, {1, true}, {0, false}, {0.3, true}});
  ASSERT_EQ(bins.size(), 10U);
  EXPECT_EQ(bins[9].right.count, 3U);
  EXPECT_NEAR(bins[9].stated, 2.9 / 3, 1e-12);
  EXPECT_NEAR(bins[9].right.value, 2.0 / 3, 1e-12);
  EXPECT_EQ(bins[0].right.count, 1U);
  EXPECT_DOUBLE_EQ(bins[3].from, 0.3);  // a bin holds its lower end
  EXPECT_EQ(bins[3].right.count, 1U);
  EXPECT_EQ(bins[5].right.count, 0U);
}

TEST(BlindCase, SealsAndReadsBack) {
  BlindSet set{"arm", "mujoco", "hang", 5, {}};
  set.cases = {caseOf(BlindKind::single, {{"com_offset", "Thigh", "y", -0.02, {{"side", "link"}}}}, 7.5)};
  set.cases[0].name = "12345";
  const BlindSet again = parseBlindSet(blindSetText(set));
  EXPECT_EQ(blindSetText(again), blindSetText(set));
  EXPECT_EQ(again.cases[0].effects[0].axis, "y");
  EXPECT_EQ(again.cases[0].effects[0].how.at("side"), "link");
  EXPECT_EQ(thrownBy([] { parseBlindSet("{}"); }),
            "no answers of a benchmark: a field is missing or of another kind");
  // FIPS 180-4's examples.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(BlindDraw, KindsInTheSharesPromised) {
  DrawOptions options;
  options.cases = 200;
  const std::vector<BlindKind> kinds = drawKinds(options);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), BlindKind::none), 40);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), BlindKind::mixture), 29);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), BlindKind::outside), 29);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), BlindKind::hard), 29);
  EXPECT_EQ(kinds.size(), 200U);
  EXPECT_EQ(kinds, drawKinds(options));
  options.seed = 2;
  EXPECT_NE(kinds, drawKinds(options));
}

}  // namespace
}  // namespace plumbline::gap
