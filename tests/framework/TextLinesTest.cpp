#include "framework/TextLines.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <vector>

namespace plumbline {
namespace {

class TextLinesTest : public testing::Test {
protected:
  void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  void pack(const std::string& text) {
    gzFile file = gzopen(path.c_str(), "wb");
    ASSERT_TRUE(file);
    EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
    EXPECT_EQ(gzclose(file), Z_OK);
  }
  /// All lines, or what is wrong without the file's name.
  std::vector<std::string> lines(std::size_t maxLength = TextLines::usualLength) {
    std::vector<std::string> all;
    try {
      TextLines text(path, maxLength);
      for (std::string_view line; text.next(line);) all.emplace_back(line);
    } catch (const TextError& error) {
      all.push_back(std::string(error.what()).substr(path.size()));
    }
    return all;
  }
  using Texts = std::vector<std::string>;

  const std::string path = testing::TempDir() + "text-lines-of-a-test";
  void TearDown() override { std::filesystem::remove(path); }
};

TEST_F(TextLinesTest, arePlainOrPacked) {
  const std::string text = "one\r\n\ntwo, three\nwithout an end";
  const Texts expected = {"one", "", "two, three", "without an end"};
  write(text);
  EXPECT_EQ(lines(), expected);
  pack(text);
  EXPECT_EQ(lines(), expected);
  write("");
  EXPECT_EQ(lines(), Texts{});
}

TEST_F(TextLinesTest, areCounted) {
  write("one\ntwo\n");
  TextLines text(path);
  std::string_view line;
  EXPECT_EQ(text.line(), 0u);
  while (text.next(line)) {
  }
  EXPECT_EQ(text.line(), 2u);
  try {
    text.fail("is the last");
    FAIL();
  } catch (const TextError& error) {
    EXPECT_EQ(error.what(), path + ":2: is the last");
  }
}

TEST_F(TextLinesTest, haveABound) {
  write("1234567\nx\n");
  EXPECT_EQ(lines(9), (Texts{"1234567", "x"})) << "eight characters with its end, and one for the reader";
  write("x\n123456789\n");
  EXPECT_EQ(lines(9), (Texts{"x", ":2: the line is longer than 9 characters"}));
}

TEST_F(TextLinesTest, holdNoNulCharacter) {
  write(std::string("a\nb\0c\nd\n", 8));
  EXPECT_EQ(lines(), (Texts{"a", ":2: holds a NUL character; the file is damaged"}));
}

TEST_F(TextLinesTest, ofADamagedFileAreAnError) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += std::to_string(i * i) + "\n";
  pack(text);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const Texts found = lines();
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found.back().ends_with(": the file is cut short")) << found.back();
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(40).write("\xff\xff\xff\xff", 4);
  EXPECT_TRUE(lines().back().ends_with("; the file is damaged") || lines().back().ends_with("cut short"));
}

TEST_F(TextLinesTest, ofAFileThatIsNotThereAreAnErrorWithAdvice) {
  try {
    TextLines("no/such.csv", 99, "; give another");
    FAIL();
  } catch (const TextError& error) {
    EXPECT_STREQ(error.what(), "no/such.csv: cannot be read; give another");
  }
}

}  // namespace
}  // namespace plumbline
