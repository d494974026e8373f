#include "web/RoboVizParser.h"

#include "simspark/NumberFormat.h"

namespace plumbline::web {

namespace {

constexpr std::size_t floatSize = 6;

/// Takes fields from the front of a datagram. After the first failure every field is zero.
class Fields {
public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  std::uint8_t byte() { return static_cast<std::uint8_t>(take(1).front()); }
  double number() {
    std::string_view text = take(floatSize);
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    const auto value = problem_.empty() ? simspark::parseNumber(text) : 0.0;
    if (!value) fail("a field is no number");
    return value.value_or(0);
  }
  Vec3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Colour colour(bool withAlpha = false) {
    Colour colour;
    colour.red = byte();
    colour.green = byte();
    colour.blue = byte();
    if (withAlpha) colour.alpha = byte();
    return colour;
  }
  std::string text() {
    const std::size_t end = rest_.find('\0');
    if (end == std::string_view::npos) return fail("a text has no end"), std::string();
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return std::string(taken);
  }
  AgentName agent() {
    const std::uint8_t code = byte();
    return {code < 128 ? simspark::TeamSide::left : simspark::TeamSide::right, code % 128 + 1};
  }

  bool empty() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }
  void fail(const char* why) {
    if (problem_.empty()) problem_ = why;
    rest_ = {};
  }
  const std::string& error() const { return problem_; }

private:
  std::string_view take(std::size_t size) {
    static constexpr char zeros[floatSize] = {};
    if (rest_.size() < size) {
      fail("the command is cut off");
      return {zeros, size};
    }
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
  std::string problem_;
};

constexpr int code(int group, int kind) { return group << 8 | kind; }

Shape polygon(Fields& fields) {
  Shape shape;
  Polygon form;
  const std::size_t corners = fields.byte();
  shape.colour = fields.colour(true);
  for (std::size_t i = 0; i < corners && fields.error().empty(); ++i) form.corners.push_back(fields.vector());
  shape.form = std::move(form);
  shape.set = fields.text();
  return shape;
}

/// The fields in the order of the wire; braces evaluate from left to right.
DrawingCommand read(int command, Fields& fields) {
  Shape shape;
  switch (command) {
    case code(0, 0):
      return SwapSets{fields.text()};
    case code(1, 0): {
      const double x = fields.number(), y = fields.number();
      const double radius = fields.number(), thickness = fields.number();
      shape.form = Circle{Vec2(x, y), radius, thickness};
      break;
    }
    case code(1, 1):
      shape.form = Line{fields.vector(), fields.vector(), fields.number()};
      break;
    case code(1, 2):
      shape.form = Point{fields.vector(), fields.number()};
      break;
    case code(1, 3):
      shape.form = Sphere{fields.vector(), fields.number()};
      break;
    case code(1, 4):
      return polygon(fields);
    case code(2, 0): {
      const Vec3 position = fields.vector();
      shape.colour = fields.colour();
      shape.form = Annotation{position, fields.text()};
      shape.set = fields.text();
      return shape;
    }
    case code(2, 1):
      return AgentText{fields.agent(), fields.colour(), fields.text()};
    case code(2, 2):
      return AgentText{fields.agent(), {}, {}};
    case code(3, 0):
      return SelectAgent{fields.agent()};
    default:
      fields.fail("no such command");
      return shape;
  }
  shape.colour = fields.colour();
  shape.set = fields.text();
  return shape;
}

}  // namespace

std::string parseDrawings(std::string_view datagram, std::vector<DrawingCommand>& commands) {
  datagram = datagram.substr(0, maxDatagram);
  Fields fields(datagram);
  while (!fields.empty()) {
    const std::size_t begin = datagram.size() - fields.left();
    const int group = fields.byte(), kind = fields.byte();
    DrawingCommand command = read(code(group, kind), fields);
    if (!fields.error().empty()) return fields.error() + ", command at byte " + std::to_string(begin);
    commands.push_back(std::move(command));
  }
  return {};
}

}  // namespace plumbline::web
