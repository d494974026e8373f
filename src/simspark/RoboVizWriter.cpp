#include "simspark/RoboVizWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace plumbline::simspark {
namespace {

constexpr std::size_t maxName = 80, maxText = 200, cornersAtOnce = 16;
constexpr double largest = 9999;  ///< that six characters hold with a sign [m]

/// The bytes of one command.
class Command {
public:
  Command(char group, char kind, bool mirrored) : mirrored_(mirrored) {
    byte(static_cast<std::uint8_t>(group));
    byte(static_cast<std::uint8_t>(kind));
  }
  void byte(std::uint8_t value) { bytes_ += static_cast<char>(value); }
  void number(double value) {
    fits_ = fits_ && std::abs(value) <= largest;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%6f", std::clamp(value, -largest, largest));
    bytes_.append(text.data(), 6);
  }
  void place(const Vec2& place) {
    number(mirrored_ ? -place.x() : place.x());
    number(mirrored_ ? -place.y() : place.y());
  }
  void place(const Vec3& at) {
    place(Vec2(at.head<2>()));
    number(at.z());
  }
  void colour(const shapes::Colour& colour) {
    byte(colour.red);
    byte(colour.green);
    byte(colour.blue);
  }
  void text(std::string_view text, std::size_t most) {
    text = shapes::cutText(text.substr(0, text.find('\0')), most);
    bytes_ += text;
    bytes_ += '\0';
  }
  bool fits() const { return fits_; }
  const std::string& bytes() const { return bytes_; }

private:
  bool mirrored_, fits_ = true;
  std::string bytes_;
};

struct ShapeWriter {
  std::string_view set;
  const shapes::Colour& colour;
  bool mirrored;
  std::vector<std::string>& datagrams;

  void send(const Command& command) const {
    if (!command.fits()) return;
    if (datagrams.empty() || datagrams.back().size() + command.bytes().size() > maxDrawingDatagram)
      datagrams.emplace_back();
    datagrams.back() += command.bytes();
  }
  void end(Command& command) const {
    command.colour(colour);
    command.text(set, maxName);
    send(command);
  }
  void operator()(const shapes::Circle& circle) const {
    Command command(1, 0, mirrored);
    command.place(circle.centre);
    command.number(circle.radius);
    command.number(circle.thickness);
    end(command);
  }
  void operator()(const shapes::Line& line) const {
    Command command(1, 1, mirrored);
    command.place(line.begin);
    command.place(line.end);
    command.number(line.thickness);
    end(command);
  }
  void operator()(const shapes::Point& point) const {
    Command command(1, 2, mirrored);
    command.place(point.position);
    command.number(point.size);
    end(command);
  }
  void operator()(const shapes::Sphere& sphere) const {
    Command command(1, 3, mirrored);
    command.place(sphere.centre);
    command.number(sphere.radius);
    end(command);
  }
  void operator()(const shapes::Polygon& polygon) const {
    // A fan, as the corners are those of a convex one.
    const std::vector<Vec3>& corners = polygon.corners;
    for (std::size_t first = 1; first + 1 < corners.size(); first += cornersAtOnce - 2) {
      const std::size_t last = std::min(first + cornersAtOnce - 2, corners.size() - 1);
      Command command(1, 4, mirrored);
      command.byte(static_cast<std::uint8_t>(last - first + 2));
      command.colour(colour);
      command.byte(colour.alpha);
      command.place(corners[0]);
      for (std::size_t i = first; i <= last; ++i) command.place(corners[i]);
      command.text(set, maxName);
      send(command);
    }
  }
  void operator()(const shapes::Annotation& text) const {
    Command command(2, 0, mirrored);
    command.place(text.position);
    command.colour(colour);
    command.text(text.text, maxText);
    command.text(set, maxName);
    send(command);
  }
};

}  // namespace

std::vector<std::string> roboVizDatagrams(std::string_view set, const std::vector<shapes::Shape>& drawn,
                                          bool mirrored) {
  std::vector<std::string> datagrams;
  for (const shapes::Shape& shape : drawn)
    std::visit(ShapeWriter{set, shape.colour, mirrored, datagrams}, shape.form);
  Command swap(0, 0, false);
  swap.text(set, maxName);
  ShapeWriter{set, {}, false, datagrams}.send(swap);
  return datagrams;
}

}  // namespace plumbline::simspark
