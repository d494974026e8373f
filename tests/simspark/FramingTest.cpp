#include "simspark/Framing.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline::simspark {
namespace {

using Status = FrameReader::Status;

TEST(Framing, lengthIsBigEndian) {
  std::string out = "x";
  appendFrame(out, std::string(0x102, 'a'));
  EXPECT_EQ(out.size(), 1 + 4 + 0x102u);
  EXPECT_EQ(out.substr(0, 6), std::string("x\0\0\1\2a", 6));
}

TEST(Framing, messagesInAnyPieces) {
  std::string stream;
  for (const char* text : {"one", "", "three"}) appendFrame(stream, text);
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    FrameReader reader(100);
    std::vector<std::string> got;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      reader.feed(std::string_view(stream).substr(at, piece));
      for (std::string_view message; reader.next(message) == Status::message;) got.emplace_back(message);
    }
    EXPECT_EQ(got, (std::vector<std::string>{"one", "", "three"})) << piece;
    EXPECT_TRUE(reader.empty());
  }
}

TEST(Framing, halfAMessageIsNotEmpty) {
  FrameReader reader(100);
  std::string_view message;
  reader.feed(std::string_view("\0\0\0\5ab", 6));
  EXPECT_EQ(reader.next(message), Status::incomplete);
  EXPECT_FALSE(reader.empty());
  reader.feed("cde");
  EXPECT_EQ(reader.next(message), Status::message);
  EXPECT_EQ(message, "abcde");
}

TEST(Framing, lengthBeyondTheLimitBreaksTheStream) {
  FrameReader reader(100);
  std::string_view message;
  reader.feed(std::string_view("\xff\xff\xff\xff(he1 1)", 11));
  EXPECT_EQ(reader.next(message), Status::tooLong);
  EXPECT_EQ(reader.announced(), 4294967295u);
  reader.feed(std::string(1 << 20, 'x'));
  EXPECT_EQ(reader.next(message), Status::tooLong);
  reader.reset();
  reader.feed(std::string_view("\0\0\0\0", 4));
  EXPECT_EQ(reader.next(message), Status::message);
}

TEST(Framing, theLimitItselfIsRead) {
  FrameReader reader(3);
  std::string_view message;
  reader.feed(std::string_view("\0\0\0\3abc\0\0\0\4", 11));
  EXPECT_EQ(reader.next(message), Status::message);
  EXPECT_EQ(reader.next(message), Status::tooLong);
}

}  // namespace
}  // namespace plumbline::simspark
