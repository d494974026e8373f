#include "framework/Shapes.h"

#include <cmath>
#include <cstdio>

namespace plumbline::shapes {
namespace {

/// Tenths of millimetres are enough to look at.
void write(OutStream& out, double value) { out.writeDouble(std::round(value * 1e4) / 1e4); }

void write(OutStream& out, const Vec3& place) {
  for (int i = 0; i < 3; ++i) write(out, place[i]);
}

struct Writer {
  OutStream& out;
  const std::string colour;

  void begin(std::string_view name) const {
    out.writeString(name);
    out.writeString(colour);
  }
  void operator()(const Circle& circle) const {
    begin("circle");
    write(out, circle.centre.x());
    write(out, circle.centre.y());
    write(out, circle.radius);
    write(out, circle.thickness);
  }
  void operator()(const Line& line) const {
    begin("line");
    write(out, line.begin);
    write(out, line.end);
    write(out, line.thickness);
  }
  void operator()(const Point& point) const {
    begin("point");
    write(out, point.position);
    write(out, point.size);
  }
  void operator()(const Sphere& sphere) const {
    begin("sphere");
    write(out, sphere.centre);
    write(out, sphere.radius);
  }
  void operator()(const Polygon& polygon) const {
    begin("polygon");
    for (const Vec3& corner : polygon.corners) write(out, corner);
  }
  void operator()(const Annotation& text) const {
    begin("text");
    write(out, text.position);
    out.writeString(text.text);
  }
};

}  // namespace

std::string colourText(const Colour& colour) {
  char text[10];
  if (colour.alpha == 255)
    std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
  else
    std::snprintf(text, sizeof text, "#%02x%02x%02x%02x", colour.red, colour.green, colour.blue,
                  colour.alpha);
  return text;
}

std::string_view cutText(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  const auto isInside = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80; };
  while (most > 0 && isInside(most)) --most;
  return text.substr(0, most);
}

void writeShape(OutStream& out, const Shape& shape) {
  out.beginObject();
  std::visit(Writer{out, colourText(shape.colour)}, shape.form);
  out.endObject();
}

}  // namespace plumbline::shapes
