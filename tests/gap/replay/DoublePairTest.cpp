#include "gap/replay/DoublePair.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace plumbline::gap {
namespace {

TEST(DoublePairTest, eachNumberAsItWouldBeAlone) {
  // From the second on, where nothing is aligned.
  std::array<double, 9> from{}, what{}, to{};
  for (std::size_t i = 0; i < from.size(); ++i) {
    from[i] = 0.1 * static_cast<double>(i + 1);
    what[i] = 0.7 - 0.3 * static_cast<double>(i);
  }
  writeDoubles(
      &to[1],
      scaled(minusScaled(readDoubles<DoubleEight>(&from[1]), 0.3, readDoubles<DoubleEight>(&what[1])), 1.1));
  EXPECT_EQ(to[0], 0);
  for (std::size_t i = 1; i < to.size(); ++i)
    EXPECT_EQ(to[i], scaled(minusScaled(from[i], 0.3, what[i]), 1.1)) << i;
  writeDoubles(
      &to[1],
      scaled(minusScaled(readDoubles<DoublePair>(&what[1]), 0.3, readDoubles<DoublePair>(&from[1])), 1.1));
  for (std::size_t i = 1; i < 3; ++i) EXPECT_EQ(to[i], scaled(minusScaled(what[i], 0.3, from[i]), 1.1)) << i;
}

TEST(DoublePairTest, addsToAsManyAsAreAskedFor) {
  for (const long n : {0, 1, 2, 5, 6}) {
    std::array<double, 7> to{}, from{};
    from.fill(0.5);
    addScaled(to.data(), 3, from.data(), n);
    for (std::size_t i = 0; i < to.size(); ++i)
      EXPECT_EQ(to[i], i < static_cast<std::size_t>(n) ? 1.5 : 0) << n;
  }
}

TEST(DoublePairTest, addsColumnsOneAfterTheOther) {
  for (const long n : {1, 2, 3, 6}) {
    std::array<double, 12> columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = 0.1 * static_cast<double>(i + 1);
    std::array<double, 6> to{}, expected{};
    to.fill(0.7);
    expected.fill(0.7);
    const auto factor = [](long k) { return k == 0 ? 0.3 : -1.1; };
    addColumns(to.data(), factor, columns.data(), 2, n);
    for (long k = 0; k < 2; ++k) addScaled(expected.data(), factor(k), columns.data() + k * n, n);
    EXPECT_EQ(to, expected) << n;
  }
}

}  // namespace
}  // namespace plumbline::gap
