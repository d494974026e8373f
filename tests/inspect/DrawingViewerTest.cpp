#include "inspect/DrawingViewer.h"

#include <gtest/gtest.h>

#include "support/Thrown.h"
#include "support/ViewerPort.h"

namespace plumbline::inspect {
namespace {

struct DrawingViewerTest : testing::Test {
  test::ViewerPort viewerPort;
  int port = viewerPort.port;
  DrawingOwner owner;
  std::string received() { return viewerPort.received(); }
};

TEST_F(DrawingViewerTest, setsAreNamedByTeamAndNumber) {
  DrawingViewer viewer({"127.0.0.1", port}, owner);
  Drawing drawing;
  drawing.point(Vec2(1, 2), {10, 20, 30}, 5);
  owner.number = 7;
  viewer.show("draw:BallLocator:ball", drawing);
  const std::string name("left.07.BallLocator:ball.\0", 26);
  EXPECT_EQ(received(), std::string("\x01\x02", 2) + "1.00002.00000.00005.0000" + "\x0a\x14\x1e" + name +
                            std::string("\0\0", 2) + name);
  owner.right = true;
  viewer.show("draw:BallLocator:ball", {});
  EXPECT_EQ(received(), std::string("\0\0", 2) + name) << "its old name's";
  EXPECT_EQ(received(), std::string("\0\0", 2) + std::string("right.07.BallLocator:ball.\0", 27));
}

TEST_F(DrawingViewerTest, whatWasShownUnderAnotherNameIsHidden) {
  DrawingViewer viewer({"127.0.0.1", port}, owner);
  viewer.show("draw:a", {});
  EXPECT_EQ(received(), std::string("\0\0left.00.a.\0", 13));
  owner.number = 4;
  owner.right = true;
  viewer.show("draw:a", {});
  EXPECT_EQ(received(), std::string("\0\0left.00.a.\0", 13)) << "it is empty now";
  EXPECT_EQ(received(), std::string("\0\0right.04.a.\0", 14));
}

TEST_F(DrawingViewerTest, anAddressIsWrittenInDigits) {
  EXPECT_EQ(thrownBy([&] {
              DrawingViewer({"viewer", port}, owner);
            }),
            "drawings: viewer is no IPv4 address, as 127.0.0.1");
}

}  // namespace
}  // namespace plumbline::inspect
