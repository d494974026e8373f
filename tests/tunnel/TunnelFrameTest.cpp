#include "tunnel/TunnelFrame.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"

namespace plumbline::tunnel {
namespace {

std::string refused(const std::string& message) {
  return thrownBy([&] { decodeFrame(message); });
}

TEST(TunnelFrame, allKindsAreReadAsTheyWereWritten) {
  for (const Frame& frame :
       {Frame{FrameKind::open, 1}, Frame{FrameKind::data, 7, 0, std::string("a\0b\xff", 4)},
        Frame{FrameKind::data, UINT32_MAX, 0, std::string(maxFrameData, 'x')}, Frame{FrameKind::end, 2},
        Frame{FrameKind::reset, 3}, Frame{FrameKind::credit, 4, creditWindow}, Frame{FrameKind::alive},
        Frame{FrameKind::ended, 0, 255}, Frame{FrameKind::over, 0, 0}, Frame{FrameKind::bye},
        Frame{FrameKind::stop, 0, 130}}) {
    const Frame read = decodeFrame(encodeFrame(frame));
    EXPECT_EQ(read.kind, frame.kind);
    EXPECT_EQ(read.connection, frame.connection);
    EXPECT_EQ(read.value, frame.value);
    EXPECT_EQ(read.data, frame.data);
  }
}

TEST(TunnelFrame, standsInTheMessageAsItIsDescribed) {
  EXPECT_EQ(encodeFrame({FrameKind::data, 0x01020304, 0, "ab"}),
            std::string("PT\1\2\4\3\2\1\2\0\0\0ab", frameHeader + 2));
  EXPECT_EQ(encodeFrame({FrameKind::credit, 1, 0x10203}), std::string("PT\1\5\1\0\0\0\3\2\1\0", frameHeader));
}

TEST(TunnelFrame, whatIsNoFrameIsRefusedWithItsReason) {
  const std::string good = encodeFrame({FrameKind::data, 1, 0, "abc"});
  EXPECT_EQ(refused(""), "frame: 0 bytes are no header");
  EXPECT_EQ(refused(good.substr(0, 11)), "frame: 11 bytes are no header");
  EXPECT_EQ(refused("XT" + good.substr(2)), "frame: does not begin as one");
  EXPECT_EQ(refused("PT\2" + good.substr(3)), "frame: of version 2, not 1");
  EXPECT_EQ(refused("PT\1\x0b" + good.substr(4)), "frame: of no kind that there is, 11");
  EXPECT_EQ(refused(std::string("PT\1\0", 4) + good.substr(4)), "frame: of no kind that there is, 0");
  EXPECT_EQ(refused(good + "d"), "frame: 4 bytes after the header, which says 3");
  EXPECT_EQ(refused(good.substr(0, good.size() - 1)), "frame: 2 bytes after the header, which says 3");
  EXPECT_EQ(refused(encodeFrame({FrameKind::open, 1}) + "x"),
            "frame: 1 bytes after the header, which says 0");
}

TEST(TunnelFrame, numbersOutOfTheirBoundsAreRefused) {
  EXPECT_EQ(refused(encodeFrame({FrameKind::open, 0})), "frame: of kind 1 for connection 0");
  EXPECT_EQ(refused(encodeFrame({FrameKind::stop, 5})), "frame: of kind 10 for connection 5");
  EXPECT_EQ(refused(encodeFrame({FrameKind::data, 1})),
            "frame: of kind 2 with 0, which is not from 1 to 32768");
  EXPECT_EQ(refused(encodeFrame({FrameKind::data, 1, 0, std::string(maxFrameData + 1, 'x')})),
            "frame: of kind 2 with 32769, which is not from 1 to 32768");
  EXPECT_EQ(refused(encodeFrame({FrameKind::credit, 1, creditWindow + 1})),
            "frame: of kind 5 with 262145, which is not from 1 to 262144");
  EXPECT_EQ(refused(encodeFrame({FrameKind::over, 0, 256})),
            "frame: of kind 8 with 256, which is not from 0 to 255");
  EXPECT_EQ(refused(encodeFrame({FrameKind::end, 1, 1})),
            "frame: of kind 3 with 1, which is not from 0 to 0");
}

}  // namespace
}  // namespace plumbline::tunnel
