#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "framework/Shapes.h"
#include "math/Types.h"
#include "simspark/TeamSide.h"

namespace plumbline::web {

// What agents draw, in RoboViz's datagram format. Metres of the field frame; thickness and point size in
// pixels.
using shapes::Annotation, shapes::Circle, shapes::Colour, shapes::Line, shapes::Point, shapes::Polygon,
    shapes::Sphere;
/// Shown, in its set, from the next swap of that set on.
struct Shape {
  shapes::Form form;
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
