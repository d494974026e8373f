#include "framework/SingleLine.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(SingleLine, controlCharactersBecomeSpaces) {
  EXPECT_EQ(singleLine("plain text, \xc3\xa4"), "plain text, \xc3\xa4");
  EXPECT_EQ(singleLine("a\nb\tc\x1b[31md\x7f"), "a b c [31md");
  EXPECT_EQ(singleLine("end \n\n"), "end");
  EXPECT_EQ(singleLine(std::string("a\0b", 3)), "a b");
}

TEST(SingleLine, whatIsLongIsCut) {
  EXPECT_EQ(singleLine(std::string(1000, 'x')), std::string(1000, 'x'));
  EXPECT_EQ(singleLine(std::string(1001, 'x')), std::string(1000, 'x') + "...");
}

}  // namespace
}  // namespace plumbline
