#include "inspect/Outbox.h"

#include <gtest/gtest.h>

namespace plumbline::inspect {
namespace {

Outcome outcome(std::uint64_t request, std::string text = "") {
  Outcome result;
  result.request = request;
  result.text = std::move(text);
  return result;
}

TEST(Outbox, givesAllInTheirOrder) {
  Outbox box;
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_TRUE(box.push(outcome(i)));
  const std::vector<Outcome> taken = box.take();
  ASSERT_EQ(taken.size(), 3U);
  for (std::uint64_t i = 0; i < 3; ++i) EXPECT_EQ(taken[i].request, i);
  EXPECT_TRUE(box.take().empty());
}

TEST(Outbox, refusesWhatIsTooManyUntilSomethingIsTaken) {
  Outbox box;
  for (std::size_t i = 0; i < Outbox::most; ++i) ASSERT_TRUE(box.push(outcome(i))) << i;
  EXPECT_FALSE(box.push(outcome(1)));
  EXPECT_EQ(box.take().size(), Outbox::most);
  EXPECT_TRUE(box.push(outcome(1)));
}

TEST(Outbox, refusesWhatIsTooLargeUntilSomethingIsTaken) {
  Outbox box;
  EXPECT_TRUE(box.push(outcome(1, std::string(Outbox::mostBytes, 'x'))));
  EXPECT_FALSE(box.push(outcome(2)));
  EXPECT_EQ(box.take().size(), 1U);
  EXPECT_TRUE(box.push(outcome(2)));
}

}  // namespace
}  // namespace plumbline::inspect
