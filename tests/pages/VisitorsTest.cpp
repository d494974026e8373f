#include "pages/Visitors.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::pages {
namespace {

struct VisitorsTest : testing::Test {
  /// Connections are only told apart: any addresses do.
  lws* at(std::size_t i) { return reinterpret_cast<lws*>(&places[i]); }
  lws* comes(std::size_t i) {
    visitors.add(at(i));
    return visitors.toClose([this](lws* connection) { return connection == sent; });
  }
  std::array<char, 8> places{};
  lws* sent = nullptr;
  Visitors visitors{2};
};

TEST_F(VisitorsTest, whoHasBeenSilentLongestGoesFirst) {
  EXPECT_EQ(comes(0), nullptr);
  EXPECT_EQ(comes(1), nullptr);
  EXPECT_EQ(comes(2), at(0));
  EXPECT_EQ(comes(3), at(1)) << "the first leaves already";
  visitors.remove(at(0));
  visitors.remove(at(1));
  EXPECT_EQ(comes(4), at(2));
}

TEST_F(VisitorsTest, whoAskedOrHasSentSomethingStays) {
  comes(0);
  visitors.asked(at(0));
  comes(1);
  EXPECT_EQ(comes(2), at(1));
  sent = at(2);
  EXPECT_EQ(comes(3), nullptr) << "of the last that came nothing is expected yet";
  EXPECT_EQ(comes(4), at(3));
  // It is read, and was no whole request.
  EXPECT_EQ(visitors.toClose([](lws*) { return false; }), at(2));
}

TEST_F(VisitorsTest, whoGoesByItselfMakesRoom) {
  comes(0);
  comes(1);
  visitors.remove(at(1));
  visitors.remove(at(1));
  visitors.asked(at(1));
  EXPECT_EQ(comes(2), nullptr);
}

}  // namespace
}  // namespace plumbline::pages
