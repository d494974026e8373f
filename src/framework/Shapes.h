#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "framework/OutStream.h"
#include "math/Types.h"

// What a drawing is made of. Metres; the frame is the drawing's. Thickness and the size of a point are
// pixels.
namespace plumbline::shapes {

struct Colour {
  std::uint8_t red = 255, green = 255, blue = 255, alpha = 255;
  bool operator==(const Colour&) const = default;
};
struct Circle {
  Vec2 centre;  ///< on the ground
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
  std::vector<Vec3> corners;  ///< convex
};
struct Annotation {
  Vec3 position;
  std::string text;
};
using Form = std::variant<Circle, Line, Point, Sphere, Polygon, Annotation>;

struct Shape {
  Form form;
  Colour colour;
};

/// "#rrggbb", with alpha "#rrggbbaa".
std::string colourText(const Colour& colour);

/// As much of a text in UTF-8 as fits into so many bytes, without half a character at its end.
std::string_view cutText(std::string_view text, std::size_t most);

/// As a list without labels, which the pages draw directly:
/// - {"circle" colour x y radius thickness}
/// - {"line" colour x y z x y z thickness}
/// - {"point" colour x y z size}
/// - {"sphere" colour x y z radius}
/// - {"polygon" colour x y z x y z ...}
/// - {"text" colour x y z text}
/// Lengths are rounded to a tenth of a millimetre.
void writeShape(OutStream& out, const Shape& shape);

}  // namespace plumbline::shapes
