#include "situation/kinds/PassCallSituationKind.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(CallExpectedTest, wordsSayWhetherItAsks) {
  CallExpected e;
  EXPECT_EQ(e.words(0), "does not ask for pass mode");
  e.asks = true;
  EXPECT_EQ(e.words(0), "asks for pass mode");
}

}  // namespace
}  // namespace plumbline
