#include "situation/SituationCanvas.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace plumbline {
namespace {

// The line ends where the head begins, so that its end does not stick out of the tip.
TEST(SituationCanvas, anArrowsHeadIsTenPixelsLongAndWideAtItsEnd) {
  const FieldSvg field(FieldSize(), Vec2(-4, -3), Vec2(4, 3), 80);
  for (const Vec2& to : {Vec2(3, 0), Vec2(0, -2), Vec2(-3, 2)}) {
    SituationCanvas canvas(field);
    canvas.arrow(Vec2(0, 0), to);
    const std::string& svg = canvas.svg();
    Vec2 begin, neck, tip, left, right;
    ASSERT_EQ(std::sscanf(svg.c_str(), "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &begin.x(),
                          &begin.y(), &neck.x(), &neck.y()),
              4);
    ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("<path"), "<path d=\"M%lf %lfL%lf %lfL%lf %lfz", &tip.x(),
                          &tip.y(), &left.x(), &left.y(), &right.x(), &right.y()),
              6);
    EXPECT_LT((begin - field.pixels(Vec2(0, 0))).norm(), 0.1);
    EXPECT_LT((tip - field.pixels(to)).norm(), 0.1);
    EXPECT_NEAR((tip - neck).norm(), 10, 0.2);
    EXPECT_NEAR((begin - neck).norm() + 10, (tip - begin).norm(), 0.3) << "along the line";
    EXPECT_NEAR((left - right).norm(), 10, 0.2);
    EXPECT_LT(((left + right) / 2 - neck).norm(), 0.2);
  }
}

}  // namespace
}  // namespace plumbline
