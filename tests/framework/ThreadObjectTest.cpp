#include "framework/ThreadObject.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace plumbline {
namespace {

std::atomic<int> alive = 0;
struct Counted {
  Counted() { ++alive; }
  ~Counted() { --alive; }
  int value = 0;
};

TEST(ThreadObject, eachThreadHasItsOwnWhichEndsWithIt) {
  static ThreadObject<Counted> objects;
  objects.get().value = 1;
  int first = -1, again = -1, inside = 0;
  std::thread([&] {
    first = objects.get().value;
    objects.get().value = 2;
    again = objects.get().value;
    inside = alive;
  }).join();
  EXPECT_EQ(first, 0);
  EXPECT_EQ(again, 2);
  EXPECT_EQ(inside, 2);
  EXPECT_EQ(alive, 1);
  EXPECT_EQ(objects.get().value, 1);
}

}  // namespace
}  // namespace plumbline
