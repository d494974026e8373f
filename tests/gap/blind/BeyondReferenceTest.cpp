#include "gap/blind/BeyondReference.h"

#include <gtest/gtest.h>

#include "gap/blind/HandMadeCases.h"
#include "gap/blind/ScoreJudge.h"
#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

/// The reference with an answer, and one case with another.
class Compared {
public:
  Compared(BlindAnswer reference, const BlindCase& c, BlindAnswer answer) : robot(twoHips()) {
    set.engine = blindRecordings;
    set.cases = {caseOf(BlindKind::none, {}), c};
    set.cases[0].name = "12345";
    set.cases[0].reference = true;
    result = beyondReference(set, {std::move(reference), std::move(answer)}, robot).back();
  }
  bool right() const { return BlindJudge(robot).right(set.cases[1], result); }

  const Mechanism robot;
  BlindSet set;
  BlindAnswer result;
};

const BlindCase nothing = caseOf(BlindKind::none, {});
BlindCase gain(double factor) { return caseOf(BlindKind::single, {{"servo_gain", "Knee", "", factor, {}}}); }

TEST(BeyondReference, theRobotsOwnCausesAreNeitherCreditNorFault) {
  const BlindAnswer own = answer("effect", {named("backlash", "Knee", 0.03, 0.9)});
  EXPECT_EQ(Compared(own, nothing, own).result.verdict, "none");
  EXPECT_EQ(Compared(own, nothing, answer("effect", {named("backlash", "Knee", 0.035, 0.9)})).result.verdict,
            "none");
  const Compared planted(
      own, gain(1.3),
      answer("effect", {named("backlash", "Knee", 0.03, 0.9), named("servo_gain", "Knee", 1.3, 0.8)}));
  EXPECT_TRUE(planted.right());
  ASSERT_EQ(planted.result.effects.size(), 1U);
}

TEST(BeyondReference, aCauseThatMovedCountsByTheDifference) {
  const BlindAnswer own = answer("effect", {named("servo_gain", "Knee", 0.8, 0.9)});
  const Compared moved(own, gain(1.5), answer("effect", {named("servo_gain", "Knee", 1.2, 0.9)}));
  EXPECT_TRUE(moved.right());
  EXPECT_NEAR(moved.result.effects[0].value, 1.5, 1e-12);
}

TEST(BeyondReference, theWrongSignIsWrong) {
  EXPECT_FALSE(
      Compared(answer("none"), gain(1.3), answer("effect", {named("servo_gain", "Knee", 0.8, 0.9)})).right());
}

TEST(BeyondReference, aCauseThatThePlantCancelsIsFoundByItsAbsence) {
  const BlindAnswer own = answer("effect", {named("servo_gain", "Knee", 0.8, 0.9)});
  EXPECT_TRUE(Compared(own, gain(1 / 0.8), answer("none")).right());
  EXPECT_FALSE(Compared(own, gain(2), answer("none")).right());
  EXPECT_EQ(Compared(own, nothing, answer("none")).result.verdict, "none");
}

TEST(BeyondReference, unknownInBothSaysNothing) {
  EXPECT_EQ(Compared(answer("unknown"), nothing, answer("unknown")).result.verdict, "none");
  EXPECT_EQ(Compared(answer("none"), nothing, answer("unknown")).result.verdict, "unknown");
  EXPECT_EQ(Compared(answer("none"), nothing, answer("")).result.verdict, "");
}

TEST(BeyondReference, theSameThingInAnotherNameIsRight) {
  BlindCase c = gain(1.3);
  c.effects[0].alike = {{"supply_voltage", "*", ""}};
  EXPECT_TRUE(
      Compared(answer("none"), c, answer("effect", {named("supply_voltage", "*", 1.3, 0.9)})).right());
  EXPECT_FALSE(Compared(answer("none"), c, answer("effect", {named("backlash", "Knee", 0.03, 0.9)})).right());
}

TEST(BeyondReference, theReferenceItselfIsNotScored) {
  Compared one(answer("effect", {named("backlash", "Knee", 0.03, 0.9)}), nothing,
               answer("effect", {named("backlash", "Knee", 0.03, 0.9)}));
  const BlindScore score = scoreBlind(one.set, {answer("effect"), one.result}, one.robot);
  EXPECT_EQ(score.figure("false_alarms").count, 1U);
  EXPECT_EQ(score.figure("false_alarms").value, 0);
}

TEST(BeyondReference, withoutTheReferencesAnswerNothingCanBeCompared) {
  EXPECT_EQ(thrownBy([] { Compared(answer(""), nothing, answer("none")); }),
            "there is no answer to case 12345, with which all others are compared; bin/gap diagnose it, too");
}

}  // namespace
}  // namespace plumbline::gap
