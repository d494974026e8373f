#include "framework/Parallel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace plumbline {
namespace {

TEST(Parallel, everyIndexIsWorkedOnOnceOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> calls(100, 0);
    parallel(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(100, 1)) << threads;
  }
  parallel(0, 2, [](std::size_t) { FAIL(); });
}

TEST(Parallel, anExceptionComesOutAndEndsTheWork) {
  std::vector<int> calls(1000, 0);
  try {
    parallel(calls.size(), 1, [&](std::size_t i) {
      if (i == 3) throw std::runtime_error("third");
      ++calls[i];
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "third");
  }
  EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), 0), 3);
}

TEST(Parallel, asManyThreadsAsAskedForOrAsCores) {
  EXPECT_EQ(threadsFor(3), 3);
  EXPECT_GE(threadsFor(0), 1);
}

}  // namespace
}  // namespace plumbline
