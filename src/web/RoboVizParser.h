#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "math/Types.h"
#include "simspark/TeamSide.h"

namespace plumbline::web {

// What agents draw, in RoboViz's datagram format. Metres of the field frame; thickness and point size in
// pixels.
struct Colour {
  std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
  bool operator==(const Colour&) const = default;
};
struct Circle {
  Vec2 centre;
  double radius, thickness;
};
struct Line {
  Vec3 begin, end;
  double thickness;
};
struct Point {
  Vec3 position;
  double size;
};
struct Sphere {
  Vec3 centre;
  double radius;
};
struct Polygon {
  std::vector<Vec3> corners;
};
struct Annotation {
  Vec3 position;
  std::string text;
};
/// Shown, in its set, from the next swap of that set on.
struct Shape {
  std::variant<Circle, Line, Point, Sphere, Polygon, Annotation> form;
  Colour colour;
  std::string set;
};

struct AgentName {
  simspark::TeamSide side = simspark::TeamSide::left;
  int unum = 1;
  auto operator<=>(const AgentName&) const = default;  // NOLINT(modernize-use-nullptr): none is there
};
/// Shows what has been drawn in all sets whose name begins so, in place of what they showed.
struct SwapSets {
  std::string prefix;
};
/// Text at a robot, at once; empty: none.
struct AgentText {
  AgentName agent;
  Colour colour;
  std::string text;
};
struct SelectAgent {
  AgentName agent;
};

using DrawingCommand = std::variant<Shape, SwapSets, AgentText, SelectAgent>;

/// As much of a datagram is read; viewers of the league read no more either.
constexpr std::size_t maxDatagram = 512;

/// Appends the commands of a datagram. At the first that is cut off, unknown or has something else than a
/// finite number in it, reading ends: what stood before it counts. Returns empty or one line with the place.
std::string parseDrawings(std::string_view datagram, std::vector<DrawingCommand>& commands);

}  // namespace plumbline::web
