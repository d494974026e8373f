#include "gap/blind/CaseText.h"

#include <gtest/gtest.h>

#include "gap/blind/HandMadeCases.h"

namespace plumbline::gap {
namespace {

const BlindEffect friction{"coulomb_friction", "LHip", "", 0.2, {}};
const BlindEffect bend{"com_offset", "Knee", "x", 0.0123, {}};

TEST(CaseText, SaysWhatACaseHides) {
  EXPECT_EQ(hidden(caseOf(BlindKind::mixture, {friction, bend})),
            "coulomb_friction at LHip 0.2, com_offset at Knee x 0.0123");
  EXPECT_EQ(hidden(caseOf(BlindKind::none, {})), "nothing");
  EXPECT_EQ(nameOfOne("supply_voltage", "*", "", 0.5), "supply_voltage at all joints 0.5");
}

TEST(CaseText, SaysWhatAnAnswerNames) {
  const auto one = named("backlash", "Knee", 1, 0.7, {{"dead_band", "Knee", "", 2, 0.25}});
  EXPECT_EQ(said(answer("effect", {one}), false), "backlash at Knee 1 (0.700)");
  EXPECT_EQ(said(answer("effect", {one}), true), "backlash at Knee 1 (0.700; or dead_band at Knee 0.250)");
  EXPECT_EQ(said(answer("unknown", {one}), false), "unknown");
  EXPECT_EQ(said(answer("unknown", {one}), true),
            "unknown, nearest backlash at Knee 1 (0.700; or dead_band at Knee 0.250)");
  EXPECT_EQ(said(answer("none"), true), "none");
  EXPECT_EQ(said(answer(""), true), "no answer");
}

TEST(CaseText, ListsWrongAnswersOrAll) {
  BlindSet set;
  set.cases = {caseOf(BlindKind::none, {}, 0), caseOf(BlindKind::single, {friction}, 8)};
  set.cases[0].name = "11";
  set.cases[1].name = "12";
  set.cases[1].ratioChannel = "position.LHip";
  const std::vector<BlindAnswer> answers = {answer("none"), answer("unknown")};
  const std::string wrong =
      "case 12, single: wrong\n  hidden: coulomb_friction at LHip 0.2; 8.0 times the noise in position.LHip\n"
      "  said:   unknown\n";
  EXPECT_EQ(caseList(set, answers, twoHips(), false), wrong);
  EXPECT_EQ(caseList(set, answers, twoHips(), true),
            "case 11, none: right\n  hidden: nothing\n  said:   none\n" + wrong);
}

}  // namespace
}  // namespace plumbline::gap
