#include "framework/SharedBlock.h"

#include <gtest/gtest.h>

#include <thread>

#include "framework/BinaryStream.h"
#include "framework/TextStream.h"

namespace plumbline {
namespace {

TEST(SharedBlockTest, copiesShareUntilOneIsChanged) {
  SharedBlock<std::uint8_t> first(3, 7);
  SharedBlock<std::uint8_t> second = first;
  EXPECT_EQ(first.values().data(), second.values().data());
  second.edit()[1] = 8;
  EXPECT_EQ(toText(first), "{7 7 7 }");
  EXPECT_EQ(toText(second), "{7 8 7 }");
  EXPECT_FALSE(first == second);
  const auto* place = second.values().data();
  second.edit()[1] = 7;
  EXPECT_EQ(second.values().data(), place) << "nobody shares it: changed where it stands";
  EXPECT_TRUE(first == second);
}

TEST(SharedBlockTest, anEmptyOneIsAnEmptyList) {
  SharedBlock<double> none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.edit().size(), 0u);
  EXPECT_EQ(toText(none), "{}");
  SharedBlock<double> copy = none;
  EXPECT_EQ(copy.size(), 0u);
  EXPECT_TRUE(copy == none);
}

TEST(SharedBlockTest, aBlockRenewedInEachCycleUsesItsMemoryAgain) {
  SharedBlock<float> made(1000);
  std::array<SharedBlock<float>, 4> onTheirWay;
  std::vector<const float*> places;
  for (std::size_t cycle = 0; cycle < 40; ++cycle) {
    made.renew(1000)[0] = static_cast<float>(cycle);
    onTheirWay[cycle % onTheirWay.size()] = made;
    for (std::size_t back = 0; back < std::min(cycle + 1, onTheirWay.size()); ++back)
      ASSERT_EQ(onTheirWay[(cycle - back) % onTheirWay.size()][0], static_cast<float>(cycle - back));
    if (std::ranges::find(places, made.values().data()) == places.end())
      places.push_back(made.values().data());
  }
  EXPECT_LE(places.size(), onTheirWay.size() + 1);
}

TEST(SharedBlockTest, streamsAsAVectorDoes) {
  const std::vector<std::int16_t> vector{1, -2, 300};
  SharedBlock<std::int16_t> block;
  ASSERT_EQ(fromBinary(toBinary(vector), block), "");
  EXPECT_EQ(toBinary(block), toBinary(vector));
  EXPECT_EQ(toText(block), toText(vector));
  SharedBlock<std::int16_t> copy = block;
  ASSERT_EQ(fromText("{4 5}", block), "");
  EXPECT_EQ(std::vector(block.begin(), block.end()), (std::vector<std::int16_t>{4, 5}));
  EXPECT_EQ(std::vector(copy.begin(), copy.end()), vector);
  EXPECT_EQ(fromText("{4 far}", block), "byte 3: expected an integer of 2 bytes, found \"far\"");
  EXPECT_EQ(fromBinary(toBinary(vector).substr(0, 9), block), "byte 8: 2 bytes needed, 1 left");
  EXPECT_EQ(block.size(), 2u) << "what cannot be read changes nothing";
}

/// One thread makes blocks, another reads them: each holds one value all over.
TEST(SharedBlockTest, goesFromThreadToThread) {
  constexpr int cycles = 2000;
  std::array<SharedBlock<int>, 2> slots;
  std::atomic<int> written{0}, read{0};
  bool whole = true;
  std::thread reader([&] {
    for (int i = 0; i < cycles; ++i) {
      while (written.load(std::memory_order_acquire) <= i) std::this_thread::yield();
      const SharedBlock<int> mine = slots[static_cast<std::size_t>(i) % 2];
      read.store(i + 1, std::memory_order_release);
      for (const int value : mine) whole = whole && value == i;
    }
  });
  SharedBlock<int> made;
  for (int i = 0; i < cycles; ++i) {
    std::ranges::fill(made.renew(64), i);
    while (read.load(std::memory_order_acquire) < i - 1) std::this_thread::yield();
    slots[static_cast<std::size_t>(i) % 2] = made;
    written.store(i + 1, std::memory_order_release);
  }
  reader.join();
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace plumbline
