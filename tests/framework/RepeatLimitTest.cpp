#include "framework/RepeatLimit.h"

#include <gtest/gtest.h>

#include "framework/Log.h"
#include "framework/LogBuffer.h"

namespace plumbline {
namespace {

TEST(RepeatLimit, letsSoManyThroughInASecondAndThenTellsHowManyMoreThereWere) {
  RepeatLimit limit(3);
  int said = 0;
  for (int i = 0; i < 100; ++i) said += limit.admit("lost", 10 + 0.001 * i).has_value();
  EXPECT_EQ(said, 3);
  EXPECT_EQ(limit.admit("found", 10.5), 0u) << "another kind";
  EXPECT_EQ(limit.admit("lost", 11.2), 97u);
  EXPECT_EQ(limit.admit("lost", 11.3), 0u);
}

TEST(RepeatLimit, tellsWhatWasKeptBackWhenNoMoreComes) {
  RepeatLimit limit(1);
  for (int i = 0; i < 5; ++i) limit.admit("lost", 1);
  EXPECT_TRUE(limit.takeOverdue(1.5).empty());
  const auto overdue = limit.takeOverdue(2.5);
  ASSERT_EQ(overdue.size(), 1u);
  EXPECT_EQ(overdue[0], std::make_pair(std::string("lost"), 4u));
  EXPECT_TRUE(limit.takeOverdue(9).empty()) << "each is said once";
}

TEST(RepeatLimit, kindsWithoutNumberCountAsOne) {
  RepeatLimit limit(2, 8);
  int said = 0;
  for (int i = 0; i < 1000; ++i) said += limit.admit("kind " + std::to_string(i), 1).has_value();
  EXPECT_EQ(said, 8 + 2);
}

TEST(RepeatLimit, addressesMakeNoOtherKind) {
  EXPECT_EQ(kindOfMessage("agent 127.0.0.1:4711 left"), kindOfMessage("agent 127.0.0.1:80 left"));
  EXPECT_NE(kindOfMessage("agent 1.2.3.4:5 left"), kindOfMessage("agent 1.2.3.4:5 came"));
  EXPECT_NE(kindOfMessage("agent 1.2.3.4:5 (Blue 8) plays"), kindOfMessage("agent 1.2.3.4:5 (Blue 9) plays"));
}

TEST(RepeatLimit, aLineThatWarnsWithoutEndIsWrittenTenTimesASecond) {
  int written = 0;
  LogBuffer::instance().setListener([&](std::string_view, std::string_view) { ++written; });
  const Log log("Flood");
  for (int i = 0; i < 1000; ++i) Log(log).warning() << "message " << i;
  EXPECT_GE(written, 10);
  EXPECT_LT(written, 200) << "a slow machine takes more than one second";
  written = 0;
  Log(log).warning() << "another line of the source";
  EXPECT_EQ(written, 1);
  LogBuffer::instance().setListener(nullptr);
}

}  // namespace
}  // namespace plumbline
