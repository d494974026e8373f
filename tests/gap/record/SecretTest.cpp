#include "gap/record/Secret.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

TEST(Seal, opensToWhatWasSealedWhateverItsLength) {
  for (const std::size_t length : {0U, 1U, 1000U, 100'000U, 500'000U}) {
    const std::string text(length, 'x');
    EXPECT_EQ(unseal(seal(text, 0x0123456789abcdef)), text) << length;
  }
}

TEST(Seal, aBrokenOrEndlessOneIsRefused) {
  const std::string sealed = seal("coulomb_friction", 7);
  const auto refused = [](const std::string& text) { return thrownBy([&] { unseal(text); }); };
  EXPECT_EQ(refused(""), "is no sealed secret");
  EXPECT_EQ(refused(sealed.substr(0, 16)), "is no sealed secret");
  EXPECT_EQ(refused(sealed + "0"), "is no sealed secret");
  EXPECT_EQ(refused(sealed.substr(0, 20) + "xx" + sealed.substr(22)), "is no sealed secret");
  std::string other = sealed;
  other[20] = other[20] == '0' ? '1' : '0';
  EXPECT_EQ(refused(other), "is no sealed secret");
  EXPECT_EQ(refused(seal(std::string(600'000, 'x'), 7)), "is no sealed secret");
}

}  // namespace
}  // namespace plumbline::gap
