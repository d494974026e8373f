#include "record/CycleRing.h"

#include <gtest/gtest.h>

#include <thread>

namespace plumbline::record {
namespace {

TEST(CycleRingTest, refusesWhatDoesNotFitAndKeepsTheRest) {
  CycleRing ring(16);
  EXPECT_TRUE(ring.push("abcdefgh"));
  EXPECT_FALSE(ring.push("x"));
  std::string block;
  EXPECT_TRUE(ring.pop(block));
  EXPECT_EQ(block, "abcdefgh");
  EXPECT_TRUE(ring.push("over the rim"));
  EXPECT_TRUE(ring.pop(block));
  EXPECT_EQ(block, "over the rim");
  EXPECT_FALSE(ring.pop(block));
  EXPECT_FALSE(ring.push(std::string(13, 'x')));
}

TEST(CycleRingTest, carriesBlocksInOrderFromThreadToThread) {
  CycleRing ring(256);
  constexpr int count = 20000;
  std::thread writer([&] {
    for (int i = 0; i < count;)
      i += ring.push(std::string(static_cast<std::size_t>(i % 50), 'a') + std::to_string(i)) ? 1 : 0;
  });
  std::string block;
  for (int i = 0; i < count;) {
    if (!ring.pop(block)) continue;
    ASSERT_EQ(block, std::string(static_cast<std::size_t>(i % 50), 'a') + std::to_string(i));
    i++;
  }
  writer.join();
}

}  // namespace
}  // namespace plumbline::record
