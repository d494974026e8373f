#include "framework/SingleLine.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>

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
  EXPECT_EQ(singleLine(std::string(1001, 'x')), std::string(1000, 'x').append("..."));
}

TEST(ErrorLine, saysWhatIsMeant) {
  EXPECT_EQ(errorLine(std::runtime_error("file:3: two\nlines")), "file:3: two lines");
  EXPECT_EQ(errorLine(std::bad_alloc()), "out of memory");
  const auto full = std::make_error_code(std::errc::no_space_on_device);
  EXPECT_EQ(errorLine(std::filesystem::filesystem_error("cannot rename", "a.part", "a", full)),
            "a.part: No space left on device");
}

}  // namespace
}  // namespace plumbline
