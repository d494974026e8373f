#include "record/CdrStream.h"

#include <gtest/gtest.h>

#include "record/ExampleLog.h"

namespace plumbline::record {
namespace {

std::string bytesOf(Representation& value) {
  CdrOutStream out;
  out.begin();
  value.stream(nullptr, &out);
  return std::string(out.bytes());
}

TEST(CdrStreamTest, readsWhatItWrote) {
  Shapes written, read;
  written.flag = true;
  written.small = -100;
  written.number = -1.25e300;
  written.text = "zwölf";
  written.names = {"", "a"};
  written.points = {Vec3(1, 2, 3)};
  EXPECT_EQ(readMessage(bytesOf(written), read), "");
  EXPECT_EQ(bytesOf(read), bytesOf(written));
  EXPECT_EQ(read.text, "zwölf");
  EXPECT_EQ(read.points.at(0), Vec3(1, 2, 3));
}

TEST(CdrStreamTest, numbersStandAtMultiplesOfTheirSizeBehindTheHeader) {
  CdrOutStream out;
  out.begin();
  out.writeBool(true);
  out.writeDouble(0);
  EXPECT_EQ(out.messageSize(), 4u + 8 + 8);
  out.begin();  // the next one is aligned by itself, wherever it stands
  out.writeBool(true);
  out.writeString("ab");
  EXPECT_EQ(out.messageSize(), 4u + 4 + 4 + 3);
  EXPECT_EQ(std::string(out.bytes().substr(20, 15)), std::string("\0\1\0\0\1\0\0\0\3\0\0\0ab\0", 15));
}

TEST(CdrStreamTest, aBlockOfNumbersIsAlignedLikeItsFirst) {
  const std::vector<double> numbers{1, 2};
  CdrOutStream block, oneByOne;
  for (CdrOutStream* out : {&block, &oneByOne}) {
    out->begin();
    out->writeBool(true);
  }
  StreamType<std::vector<double>>::write(block, numbers);
  StreamType<std::vector<double>>::write(block, {});
  oneByOne.beginList(2, true);
  for (const double number : numbers) oneByOne.writeDouble(number);
  oneByOne.beginList(0, true);
  EXPECT_EQ(block.bytes(), oneByOne.bytes());
  const auto readAll = [&](std::string_view bytes) {
    CdrInStream in(bytes);
    bool flag = false;
    std::vector<double> read, none{7};
    StreamType<bool>::read(in, flag);
    StreamType<std::vector<double>>::read(in, read);
    StreamType<std::vector<double>>::read(in, none);
    EXPECT_TRUE(!in.ok() || (in.atEnd() && read == numbers && none.empty()));
    return in.error();
  };
  EXPECT_EQ(readAll(block.bytes()), "");
  EXPECT_EQ(readAll(block.bytes().substr(0, 4 + 8 + 8 + 5)), "byte 20: 8 bytes needed, 5 left");
  EXPECT_EQ(readAll(block.bytes().substr(0, 4 + 8 + 3)), "byte 12: 8 bytes needed, 3 left");
}

TEST(CdrStreamTest, whatIsBrokenIsAnError) {
  Shapes shapes;
  const std::string good = bytesOf(shapes);
  for (std::size_t size = 0; size < good.size(); ++size) {
    Shapes read;
    EXPECT_NE(readMessage(std::string_view(good).substr(0, size), read), "") << size;
  }
  Shapes read;
  EXPECT_EQ(readMessage(good + "x", read), "byte " + std::to_string(good.size()) + ": bytes left over");
  std::string big = good;
  big[1] = 0;
  EXPECT_EQ(readMessage(big, read), "byte 4: is no little-endian CDR");
}

TEST(CdrStreamTest, aLieAboutALengthTakesNoMemory) {
  CdrOutStream out;
  out.begin();
  out.writeUnsigned(0xfffffff0, 4);
  std::vector<double> list;
  EXPECT_EQ(readMessage(out.bytes(), list), "byte 8: length 4294967280 above 1048576");
}

}  // namespace
}  // namespace plumbline::record
