#include "pages/BoardPages.h"

#include <gtest/gtest.h>

namespace plumbline::pages {
namespace {

std::string next(PageSession& session) {
  std::string text;
  return session.next(text) == PageSession::Kind::text ? text : "nothing";
}

TEST(BoardPagesTest, aPageGetsWhatStandsThereAndThenWhatChanges) {
  BoardPages board;
  board.put("a", "first");
  board.put("b", "second");
  const auto page = board.open();
  EXPECT_EQ(next(*page), "first");
  EXPECT_EQ(next(*page), "second");
  EXPECT_EQ(next(*page), "nothing");
  board.put("a", "third");
  board.put("a", "fourth");
  EXPECT_EQ(next(*page), "fourth");
  EXPECT_EQ(next(*page), "nothing");
  EXPECT_EQ(next(*board.open()), "second");
}

TEST(BoardPagesTest, newsAreSent) {
  BoardPages board;
  int news = 0;
  board.onNews([&] { ++news; });
  board.put("a", "1");
  board.put("a", "2");
  EXPECT_EQ(news, 2);
  board.onNews({});
  board.put("a", "3");
  EXPECT_EQ(news, 2);
}

TEST(BoardPagesTest, aPageThatTalksIsNotListenedTo) {
  BoardPages board;
  const auto page = board.open();
  EXPECT_TRUE(page->receive("anything"));
  EXPECT_EQ(next(*page), "nothing");
}

}  // namespace
}  // namespace plumbline::pages
