// What simspark/RoboVizWriter.h writes is what web/RoboVizParser.h reads.
#include "simspark/RoboVizWriter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/Drawing.h"
#include "web/RoboVizParser.h"

namespace plumbline::web {
namespace {

std::vector<DrawingCommand> read(const Drawing& drawing, bool mirrored = false) {
  std::vector<DrawingCommand> commands;
  for (const std::string& datagram :
       simspark::roboVizDatagrams("left.01.test.", drawing.shapes(), mirrored)) {
    EXPECT_LE(datagram.size(), maxDatagram);
    EXPECT_EQ(parseDrawings(datagram, commands), "");
  }
  EXPECT_EQ(std::get<SwapSets>(commands.back()).prefix, "left.01.test.");
  commands.pop_back();
  return commands;
}

template <typename Form>
const Form& form(const DrawingCommand& command) {
  EXPECT_EQ(std::get<Shape>(command).set, "left.01.test.");
  return std::get<Form>(std::get<Shape>(command).form);
}

TEST(RoboVizWriterTest, shapesArriveAsTheyWereDrawn) {
  Drawing drawing;
  drawing.circle(Vec2(1.5, -2), 0.25, {1, 2, 3}, 4);
  drawing.line(Vec3(1, 2, 3), Vec3(-10.5, 0.0625, 0), {9, 8, 7}, 1.5);
  drawing.point(Vec2(14.25, -9.75), {1, 2, 3}, 6);
  drawing.sphere(Vec3(0, 1, 2), 0.05, {1, 2, 3});
  drawing.text(Vec3(1, 2, 0.5), "walk", {4, 5, 6});
  const auto commands = read(drawing);
  ASSERT_EQ(commands.size(), 5u);
  EXPECT_EQ(form<Circle>(commands[0]).centre, Vec2(1.5, -2));
  EXPECT_EQ(form<Circle>(commands[0]).thickness, 4);
  EXPECT_EQ(std::get<Shape>(commands[0]).colour, (Colour{1, 2, 3}));
  EXPECT_EQ(form<Line>(commands[1]).begin, Vec3(1, 2, 3));
  EXPECT_TRUE(form<Line>(commands[1]).end.isApprox(Vec3(-10.5, 0.0625, 0), 1e-3));
  EXPECT_EQ(form<Point>(commands[2]).size, 6);
  EXPECT_EQ(form<Sphere>(commands[3]).radius, 0.05);
  EXPECT_EQ(form<Annotation>(commands[4]).text, "walk");
}

TEST(RoboVizWriterTest, theRightTeamsFieldIsTurned) {
  Drawing drawing;
  drawing.point(Vec3(1, -2, 3), colours::red);
  EXPECT_EQ(form<Point>(read(drawing, true).at(0)).position, Vec3(-1, 2, 3));
}

TEST(RoboVizWriterTest, manyShapesAndCornersNeedSeveralDatagrams) {
  Drawing drawing;
  for (int i = 0; i < 100; ++i) drawing.point(Vec2(i, 0), colours::red);
  std::vector<Drawing::Place> corners;
  for (int i = 0; i < 40; ++i) corners.emplace_back(Vec2(std::cos(0.157 * i), std::sin(0.157 * i)));
  drawing.polygon(corners, colours::faint(colours::red, 0.5));
  const auto commands = read(drawing);
  std::size_t triangles = 0;
  for (std::size_t i = 100; i < commands.size(); ++i) {
    EXPECT_EQ(std::get<Shape>(commands[i]).colour.alpha, 127);
    triangles += form<Polygon>(commands[i]).corners.size() - 2;
  }
  EXPECT_EQ(triangles, 38u);
}

TEST(RoboVizWriterTest, whatSixCharactersCannotHoldIsLeftOut) {
  Drawing drawing;
  drawing.point(Vec2(1e7, 0), colours::red);
  drawing.point(Vec2(-12.345678, 1e-9), colours::red);
  drawing.text(Vec2(0, 0), std::string(199, 'a') + "\u00e4", colours::red);
  const auto commands = read(drawing);
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_TRUE(form<Point>(commands[0]).position.isApprox(Vec3(-12.34, 0, 0), 1e-6));
  EXPECT_EQ(form<Annotation>(commands[1]).text, std::string(199, 'a')) << "no half character";
}

}  // namespace
}  // namespace plumbline::web
