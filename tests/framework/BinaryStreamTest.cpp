#include "framework/BinaryStream.h"

#include <gtest/gtest.h>

#include "framework/StreamExamples.h"
#include "framework/TextStream.h"

namespace plumbline {
namespace {

TEST(BinaryStreamTest, isOneValueAfterAnother) {
  Example example;
  example.a = 0x01020304;
  const std::string bytes = toBinary(example);
  ASSERT_EQ(bytes.size(), 4u + 4u + 8u + 16u);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x04\x03\x02\x01\x03\x00\x00\x00", 8));
}

TEST(BinaryStreamTest, stringsAndListsCarryTheirLength) {
  EXPECT_EQ(toBinary(std::string("abc")), std::string("\x03\x00\x00\x00"
                                                      "abc",
                                                      7));
  EXPECT_EQ(toBinary(std::vector<char>{'a', 'b'}), std::string("\x02\x00\x00\x00"
                                                               "ab",
                                                               6));
  EXPECT_EQ(toBinary(std::array<char, 2>{'a', 'b'}), "ab");
}

TEST(BinaryStreamTest, readsBackWhatItWrote) {
  Everything changed;
  changed.list.clear();
  changed.flag = false;
  changed.colour = Colour::red;
  changed.text = "";
  changed.large = 0;
  changed.small = 0;
  changed.real = 0;
  changed.some = std::nullopt;
  changed.pose.setIdentity();
  EXPECT_EQ(fromBinary(toBinary(Everything()), changed), "");
  EXPECT_EQ(toText(changed), toText(Everything()));
}

TEST(BinaryStreamTest, everyShorterInputIsAnErrorThatChangesNothing) {
  const std::string bytes = toBinary(Everything());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Everything value;
    value.small = 42;
    EXPECT_NE(fromBinary(std::string_view(bytes).substr(0, size), value), "") << size;
    EXPECT_EQ(value.small, 42);
  }
}

template <typename T>
std::string errorOf(const std::string& bytes) {
  T value{};
  return fromBinary(bytes, value);
}

TEST(BinaryStreamTest, saysWhatIsWrongAndWhere) {
  using namespace std::string_literals;
  EXPECT_EQ(errorOf<double>("1234567"), "byte 0: 8 bytes needed, 7 left");
  EXPECT_EQ(errorOf<int>("12345"), "byte 4: bytes left over");
  EXPECT_EQ(errorOf<bool>("\x02"), "byte 1: a bool is 0 or 1");
  EXPECT_EQ(errorOf<Colour>("\x03"), "byte 1: enum value 3 out of range");
  EXPECT_EQ(errorOf<std::string>("\xff\xff\xff\xff"), "byte 4: length 4294967295 above 16777216");
  EXPECT_EQ(errorOf<std::string>("\x05\0\0\0abc"s), "byte 4: 5 bytes needed, 3 left");
  EXPECT_EQ(errorOf<std::vector<int>>("\xff\xff\xff\x7f"), "byte 4: length 2147483647 above 1048576");
  EXPECT_EQ(errorOf<std::vector<int>>("\0\0\x10\0\1\0\0\0"s), "byte 8: 4 bytes needed, 0 left");
  EXPECT_EQ(errorOf<std::optional<int>>("\2\0\0\0\1\0\0\0\1\0\0\0"s),
            "byte 8: an optional value holds one element at most");
}

TEST(BinaryStreamTest, blocksOfNumbersHaveTheBytesOfTheirNumbers) {
  const std::vector<std::int16_t> numbers{1, -2, 300};
  std::string oneByOne("\3\0\0\0", 4);
  BinaryOutStream out(oneByOne);
  for (const std::int16_t number : numbers) out.writeSigned(number, 2);
  EXPECT_EQ(toBinary(numbers), oneByOne);
  Eigen::Matrix<float, 2, 3> matrix;
  matrix << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(toBinary(matrix), toBinary(std::array<float, 6>{1, 2, 3, 4, 5, 6})) << "row by row";
  Eigen::Matrix<float, 2, 3> read;
  ASSERT_EQ(fromBinary(toBinary(matrix), read), "");
  EXPECT_EQ(read, matrix);
}

TEST(BinaryStreamTest, aBlockThatIsCutShortSaysWhereItEnds) {
  using namespace std::string_literals;
  EXPECT_EQ(errorOf<std::vector<double>>("\2\0\0\0"s + std::string(13, 'x')),
            "byte 12: 8 bytes needed, 5 left");
  EXPECT_EQ((errorOf<std::array<float, 3>>(std::string(10, 'x'))), "byte 8: 4 bytes needed, 2 left");
  EXPECT_EQ(errorOf<Eigen::Vector3d>(std::string(23, 'x')), "byte 16: 8 bytes needed, 7 left");
  std::vector<std::uint8_t> kept{1, 2};
  EXPECT_NE(fromBinary("\xff\xff\x0f\0xyz"s, kept), "");
  EXPECT_EQ(kept, (std::vector<std::uint8_t>{1, 2}));
}

TEST(BinaryStreamTest, sizeAndMemoryAreThoseOfTheString) {
  const std::string bytes = toBinary(Everything());
  BinaryOut<CountingSink> counted;
  StreamType<Everything>::write(counted, Everything());
  EXPECT_EQ(counted.sink().size(), bytes.size());
  std::string memory(bytes.size(), 0);
  BinaryOut<MemorySink> filled(memory.data(), memory.size());
  StreamType<Everything>::write(filled, Everything());
  EXPECT_EQ(memory, bytes);
  EXPECT_FALSE(filled.sink().full());
  EXPECT_EQ(filled.sink().left(), 0u);
  BinaryOut<MemorySink> small(memory.data(), memory.size() - 1);
  StreamType<Everything>::write(small, Everything());
  EXPECT_TRUE(small.sink().full());
}

/// A tree: the depth of the input is up to the sender.
struct Tree {
  std::vector<Tree> children;
  void stream(InStream* in, OutStream* out) { STREAM(children); }
};

TEST(BinaryStreamTest, depthIsBounded) {
  std::string bytes, text;
  for (int i = 0; i < 1000; ++i) {
    bytes += std::string("\1\0\0\0", 4);
    text += "{{";
  }
  EXPECT_EQ(errorOf<Tree>(bytes), "byte 128: nested too deeply");
  Tree tree;
  EXPECT_EQ(fromText(text, tree), "byte 65: nested too deeply");
  tree.children.resize(3);
  Tree copy;
  EXPECT_EQ(fromBinary(toBinary(tree), copy), "");
  EXPECT_EQ(copy.children.size(), 3u);
}

}  // namespace
}  // namespace plumbline
