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

/// Byte for byte what RoboViz's own classes read (rv.comm.drawing, commit e1786e8): `parse` of Circle, Line,
/// Sphere, Polygon and StandardAnnotation take their fields in this order, numbers as six characters, texts
/// in UTF-8 to a zero.
TEST(RoboVizWriterTest, fieldsStandInTheOrderInWhichRoboVizTakesThem) {
  const auto bytes = [](const Drawing& drawing) {
    return simspark::roboVizDatagrams("s", drawing.shapes(), false).at(0);
  };
  const std::string end = std::string("s\0", 2) + std::string("\0\0s\0", 4), rgb = "\x0a\x14\x1e";
  Drawing circle, line, sphere, polygon, text;
  circle.circle(Vec2(1, -2), 0.5, {10, 20, 30}, 3);
  EXPECT_EQ(bytes(circle), std::string("\1\0", 2) + "1.0000-2.0000.50003.0000" + rgb + end);
  line.line(Vec3(1, 2, 3), Vec3(-4, 5, 60), {10, 20, 30}, 2);
  EXPECT_EQ(bytes(line), "\1\1" + std::string("1.00002.00003.0000-4.0005.000060.0002.0000") + rgb + end);
  sphere.sphere(Vec3(1, 2, 3), 0.25, {10, 20, 30});
  EXPECT_EQ(bytes(sphere), "\1\3" + std::string("1.00002.00003.00000.2500") + rgb + end);
  polygon.polygon({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {10, 20, 30, 40});
  EXPECT_EQ(bytes(polygon),
            "\1\4\3" + rgb + "\x28" + "0.00000.00000.00001.00000.00000.00000.00001.00000.0000" + end);
  text.text(Vec3(1, 2, 3), "\u00e4", {10, 20, 30});
  EXPECT_EQ(bytes(text),
            std::string("\2\0", 2) + "1.00002.00003.0000" + rgb + std::string("\u00e4\0", 3) + end);
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
