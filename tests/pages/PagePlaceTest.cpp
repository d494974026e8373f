#include "pages/PagePlace.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"

namespace plumbline::pages {
namespace {

TEST(PagePlaceTest, beyondLoopbackAPageNeedsAToken) {
  EXPECT_EQ(bindProblem("127.0.0.1", ""), "");
  EXPECT_EQ(bindProblem("0.0.0.0", "secret"), "");
  EXPECT_EQ(bindProblem("0.0.0.0", "", {"--web-address", "--web-token"}),
            "--web-address 0.0.0.0 opens the page to others: set a --web-token");
  PageServer::Config config;
  config.address = "0.0.0.0";
  EXPECT_EQ(thrownBy([&] { completed(config, {}); }),
            "--bind 0.0.0.0 opens the page to others: set a --token");
}

TEST(PagePlaceTest, saysWherePagesAreMissing) {
  PageServer::Config config;
  config.folder = "/nowhere";
  EXPECT_EQ(thrownBy([&] { completed(config, {}); }),
            "/nowhere: no page there; `make web` builds it into build/web");
}

TEST(PagePlaceTest, theAddressIsWhatOneTypes) {
  PageServer::Config config;
  EXPECT_EQ(addressOf(config, 8090), "http://localhost:8090/");
  config.address = "192.168.1.5";
  config.token = "secret";
  EXPECT_EQ(addressOf(config, 80), "http://192.168.1.5:80/?token=secret");
}

}  // namespace
}  // namespace plumbline::pages
