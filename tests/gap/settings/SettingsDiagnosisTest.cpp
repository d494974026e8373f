#include "gap/settings/SettingsDiagnosis.h"

#include <gtest/gtest.h>

#include "gap/LeagueTraces.h"

namespace plumbline::gap {
namespace {

// The others, which take longer, are in tests/diagnosis.
TEST(SettingsDiagnosis, NothingIsMissingWhereNothingIs) {
  const SettingsDiagnosis diagnosis = diagnosisOfTraces({});
  EXPECT_EQ(diagnosis.verdict, Verdict::none);
  EXPECT_TRUE(diagnosis.findings.empty());
}

}  // namespace
}  // namespace plumbline::gap
