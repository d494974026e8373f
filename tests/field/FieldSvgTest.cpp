#include "field/FieldSvg.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(FieldSvg, placesTheWholeFieldWithAMargin) {
  const FieldSvg svg(FieldSize(), 1.2, 30);
  EXPECT_DOUBLE_EQ(svg.width(), 972);
  EXPECT_DOUBLE_EQ(svg.height(), 672);
  EXPECT_TRUE(svg.pixels({0, 0}).isApprox(Vec2(486, 336)));
  EXPECT_TRUE(svg.pixels({15, 10}).isApprox(Vec2(936, 36))) << "y is up on the field, and down in pictures";
  EXPECT_TRUE(contains(svg.head(56), "width=\"972\" height=\"728\" viewBox=\"0 0 972 728\""));
}

TEST(FieldSvg, placesAPartOfIt) {
  const FieldSvg svg(FieldSize(), {10, -2}, {16, 1}, 100);
  EXPECT_DOUBLE_EQ(svg.width(), 600);
  EXPECT_DOUBLE_EQ(svg.height(), 300);
  EXPECT_TRUE(svg.pixels({11, 0}).isApprox(Vec2(100, 100)));
  EXPECT_DOUBLE_EQ(svg.length(0.5), 50);
}

TEST(FieldSvg, drawsTheLinesOfAnyField) {
  FieldSize small;
  small.length = 10;
  small.width = 8;
  small.goalWidth = 2;
  small.goalDepth = 1;
  small.penaltyDepth = 1;
  small.penaltyWidth = 4;
  small.centreCircleRadius = 1.5;
  const std::string lines = FieldSvg(small, 1, 10).lines();
  EXPECT_TRUE(contains(lines, "<rect x=\"10.0\" y=\"10.0\" width=\"100.0\" height=\"80.0\"")) << lines;
  EXPECT_TRUE(contains(lines, "<rect x=\"100.0\" y=\"30.0\" width=\"10.0\" height=\"40.0\""))
      << "penalty area";
  EXPECT_TRUE(contains(lines, "<rect x=\"110.0\" y=\"40.0\" width=\"10.0\" height=\"20.0\"")) << "goal";
  EXPECT_TRUE(contains(lines, "<line x1=\"60.0\" y1=\"90.0\" x2=\"60.0\" y2=\"10.0\""));
  EXPECT_TRUE(contains(lines, "<circle cx=\"60.0\" cy=\"50.0\" r=\"15\""));
}

TEST(FieldSvg, textIsNeverTakenForMarks) {
  EXPECT_EQ(svgText(1, 2, "a<b & \"c\">\n", "fill=\"red\""),
            "<text x=\"1.0\" y=\"2.0\" fill=\"red\">a&lt;b &amp; &quot;c&quot;&gt; </text>\n");
}

}  // namespace
}  // namespace plumbline
