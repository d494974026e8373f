#include "web/RoboVizParser.h"

#include <gtest/gtest.h>

namespace plumbline::web {
namespace {

using simspark::TeamSide;
using std::string_literals::operator""s;

std::vector<DrawingCommand> parsed(const std::string& datagram) {
  std::vector<DrawingCommand> commands;
  EXPECT_EQ(parseDrawings(datagram, commands), "");
  return commands;
}

template <class Form>
const Form& only(const std::vector<DrawingCommand>& commands, const Colour& colour, const std::string& set) {
  EXPECT_EQ(commands.size(), 1u);
  const Shape& shape = std::get<Shape>(commands.at(0));
  EXPECT_EQ(shape.colour, colour);
  EXPECT_EQ(shape.set, set);
  return std::get<Form>(shape.form);
}

TEST(RoboVizParser, circle) {
  const std::string bytes =
      "\x01\x00"s + "-1.250" + " 2.500" + "0.7500" + "3.0000" + "\x0a\xff\x80" + "l_1\0"s;
  ASSERT_EQ(bytes.size(), 30u + 3u);
  const auto commands = parsed(bytes);
  const auto& circle = only<Circle>(commands, {10, 255, 128, 255}, "l_1");
  EXPECT_EQ(circle.centre, Vec2(-1.25, 2.5));
  EXPECT_EQ(circle.radius, 0.75);
  EXPECT_EQ(circle.thickness, 3);
}

TEST(RoboVizParser, line) {
  const std::string bytes = "\x01\x01"s + "1.0000" + "2.0000" + "3.0000" + "-4.000" + "-5.000" + "-6.000" +
                            "1.5   " + "\x01\x02\x03" + "a\0"s;
  ASSERT_EQ(bytes.size(), 48u + 1u);
  const auto commands = parsed(bytes);
  const auto& line = only<Line>(commands, {1, 2, 3, 255}, "a");
  EXPECT_EQ(line.begin, Vec3(1, 2, 3));
  EXPECT_EQ(line.end, Vec3(-4, -5, -6));
  EXPECT_EQ(line.thickness, 1.5);
}

TEST(RoboVizParser, pointAndSphereInOneDatagram) {
  const std::string point = "\x01\x02"s + "1.0000" + "2.0000" + "3.0000" + "8.0000" + "\x01\x02\x03" + "\0"s;
  const std::string sphere =
      "\x01\x03"s + "4.0000" + "5.0000" + "6.0000" + "0.1000" + "\x04\x05\x06" + "b\0"s;
  ASSERT_EQ(point.size(), 30u);
  ASSERT_EQ(sphere.size(), 30u + 1u);
  const auto commands = parsed(point + sphere);
  ASSERT_EQ(commands.size(), 2u);
  const Shape& first = std::get<Shape>(commands[0]);
  EXPECT_EQ(first.set, "") << "a set may have no name";
  EXPECT_EQ(std::get<Point>(first.form).position, Vec3(1, 2, 3));
  EXPECT_EQ(std::get<Point>(first.form).size, 8);
  const Shape& second = std::get<Shape>(commands[1]);
  EXPECT_EQ(std::get<Sphere>(second.form).centre, Vec3(4, 5, 6));
  EXPECT_EQ(std::get<Sphere>(second.form).radius, 0.1);
  EXPECT_EQ(second.colour, (Colour{4, 5, 6, 255}));
}

TEST(RoboVizParser, polygon) {
  std::string bytes = "\x01\x04\x03\x01\x02\x03\x40"s;
  for (const char* number :
       {"0.0000", "0.0000", "0.0000", "1.0000", "0.0000", "0.0000", "1.0000", "1.0000", "0.5000"})
    bytes += number;
  bytes += "area\0"s;
  ASSERT_EQ(bytes.size(), 8u + 18u * 3u + 4u);
  const auto commands = parsed(bytes);
  const auto& polygon = only<Polygon>(commands, {1, 2, 3, 64}, "area");
  ASSERT_EQ(polygon.corners.size(), 3u);
  EXPECT_EQ(polygon.corners[2], Vec3(1, 1, 0.5));
}

TEST(RoboVizParser, annotation) {
  const std::string bytes =
      "\x02\x00"s + "1.0000" + "2.0000" + "0.5000" + "\xff\x00\x7f"s + "h\xc3\xa9\0set\0"s;
  ASSERT_EQ(bytes.size(), 25u + 3u + 3u);
  const auto commands = parsed(bytes);
  const auto& annotation = only<Annotation>(commands, {255, 0, 127, 255}, "set");
  EXPECT_EQ(annotation.position, Vec3(1, 2, 0.5));
  EXPECT_EQ(annotation.text, "h\xc3\xa9");
}

TEST(RoboVizParser, textsAndSelectionOfAgents) {
  const std::string left = "\x02\x01\x06\x01\x02\x03go\0"s, clear = "\x02\x02\x8a"s, select = "\x03\x00\x80"s;
  ASSERT_EQ(left.size(), 7u + 2u);
  ASSERT_EQ(clear.size(), 3u);
  const auto commands = parsed(left + clear + select);
  ASSERT_EQ(commands.size(), 3u);
  const auto& text = std::get<AgentText>(commands[0]);
  EXPECT_EQ(text.agent, (AgentName{TeamSide::left, 7}));
  EXPECT_EQ(text.colour, (Colour{1, 2, 3, 255}));
  EXPECT_EQ(text.text, "go");
  EXPECT_EQ(std::get<AgentText>(commands[1]).agent, (AgentName{TeamSide::right, 11}));
  EXPECT_EQ(std::get<AgentText>(commands[1]).text, "");
  EXPECT_EQ(std::get<SelectAgent>(commands[2]).agent, (AgentName{TeamSide::right, 1}));
}

TEST(RoboVizParser, swaps) {
  const auto commands = parsed("\x00\x00l_1\0\x00\x00\0"s);
  ASSERT_EQ(commands.size(), 2u);
  EXPECT_EQ(std::get<SwapSets>(commands[0]).prefix, "l_1");
  EXPECT_EQ(std::get<SwapSets>(commands[1]).prefix, "");
}

TEST(RoboVizParser, whatStandsBeforeAMistakeCounts) {
  const std::string good = "\x00\x00x\0"s;
  const auto problemOf = [&](const std::string& rest) {
    std::vector<DrawingCommand> commands;
    const std::string problem = parseDrawings(good + rest + good, commands);
    EXPECT_EQ(commands.size(), 1u) << rest;
    return problem;
  };
  const std::string sphere = "\x01\x03"s + "4.0000" + "5.0000" + "6.0000";
  EXPECT_EQ(problemOf(sphere + "0.1x00" + "\x04\x05\x06"s + "b\0"s),
            "a field is no number, command at byte 4");
  EXPECT_EQ(problemOf(sphere + "nan   " + "\x04\x05\x06"s + "b\0"s),
            "a field is no number, command at byte 4");
  EXPECT_EQ(problemOf(sphere + "      " + "\x04\x05\x06"s + "b\0"s),
            "a field is no number, command at byte 4");
  EXPECT_EQ(problemOf("\x01\x05"s), "no such command, command at byte 4");
  EXPECT_EQ(problemOf("\x09\x00"s), "no such command, command at byte 4");
}

TEST(RoboVizParser, everyCutIsNoticed) {
  const std::string whole = "\x01\x04\x01\x01\x02\x03\x40"s + "0.0000" + "1.0000" + "2.0000" + "area\0"s;
  for (std::size_t size = 1; size < whole.size(); ++size) {
    std::vector<DrawingCommand> commands;
    EXPECT_NE(parseDrawings(whole.substr(0, size), commands), "") << size;
    EXPECT_TRUE(commands.empty()) << size;
  }
}

TEST(RoboVizParser, readsNoMoreThanViewersDo) {
  const std::string swap = "\x00\x00"s + std::string(61, 's') + '\0';  // 64 bytes
  std::string datagram;
  for (int i = 0; i < 9; ++i) datagram += swap;
  std::vector<DrawingCommand> commands;
  EXPECT_EQ(parseDrawings(datagram, commands), "");
  EXPECT_EQ(commands.size(), 8u);
}

}  // namespace
}  // namespace plumbline::web
