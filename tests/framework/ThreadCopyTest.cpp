#include "framework/ThreadCopy.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

namespace plumbline {

/// Large enough to tear, and with members that own memory.
REPRESENTATION(Bulk)
class Bulk : public BulkBase {
public:
  std::array<std::uint64_t, 127> numbers{};
  std::string text;
  std::vector<std::uint64_t> list;
  void stream(InStream* in, OutStream* out) override {
    STREAM(numbers);
    STREAM(text);
    STREAM(list);
  }
  void fill(std::uint64_t value) {
    numbers.fill(value);
    text = std::to_string(value);
    list.assign(value % 50, value);
  }
  bool isWhole() const {
    for (const auto number : numbers) {
      if (number != numbers[0]) return false;
    }
    return (text.empty() ? "0" : text) == std::to_string(numbers[0]) &&
           list == std::vector<std::uint64_t>(numbers[0] % 50, numbers[0]);
  }
};

REPRESENTATION(Small)
class Small : public SmallBase {
public:
  std::uint64_t value = 0;
};

namespace {

TEST(ThreadCopyTest, fetchesTheNewestOnce) {
  Small source, target;
  ThreadCopy copy;
  copy.add(representationLoader<Small>(), source, target);
  EXPECT_FALSE(copy.fetch());
  for (source.value = 1; source.value <= 5; source.value++) copy.publish();
  EXPECT_TRUE(copy.fetch());
  EXPECT_EQ(target.value, 5u);
  EXPECT_FALSE(copy.fetch());
  source.value = 7;
  EXPECT_FALSE(copy.fetch());
  copy.publish();
  EXPECT_TRUE(copy.fetch());
  EXPECT_EQ(target.value, 7u);
}

TEST(ThreadCopyTest, neverTearsNeverGoesBackAndKeepsACycleTogether) {
  Bulk source, target;
  Small sourceSmall, targetSmall;
  ThreadCopy copy;
  copy.add(representationLoader<Bulk>(), source, target);
  copy.add(representationLoader<Small>(), sourceSmall, targetSmall);
  std::atomic<bool> end{false};
  std::thread writer([&] {
    for (std::uint64_t i = 1; !end; ++i) {
      source.fill(i);
      sourceSmall.value = i;
      copy.publish();
    }
  });
  std::uint64_t last = 0;
  for (int fetched = 0; fetched < 500;) {
    if (!copy.fetch()) {
      std::this_thread::yield();
      continue;
    }
    fetched++;
    ASSERT_TRUE(target.isWhole());
    ASSERT_EQ(target.numbers[0], targetSmall.value);
    ASSERT_GT(targetSmall.value, last);
    last = targetSmall.value;
  }
  end = true;
  writer.join();
}

}  // namespace
}  // namespace plumbline
