#include "framework/Loopback.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Loopback, onlyItsAddressesAndLocalhost) {
  for (const char* good : {"localhost", "127.0.0.1", "127.1.2.3", "::1"})
    EXPECT_TRUE(isLoopbackAddress(good)) << good;
  for (const char* bad :
       {"", "127.evil.example", "127.0.0.1.evil.example", "127.0.0.1@evil.example", "127.", "127.0.0.1 ",
        "localhost.evil.example", "0.0.0.0", "128.0.0.1", "::", "::2", "1270.0.1", "127.0.0.256"})
    EXPECT_FALSE(isLoopbackAddress(bad)) << bad;
}

TEST(Loopback, secrets) {
  EXPECT_TRUE(sameSecret("abc", "abc"));
  EXPECT_FALSE(sameSecret("abc", "abd"));
  EXPECT_FALSE(sameSecret("abc", "ab"));
  EXPECT_FALSE(sameSecret("", "a"));
}

}  // namespace
}  // namespace plumbline
