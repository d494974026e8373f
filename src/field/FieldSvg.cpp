#include "field/FieldSvg.h"

#include <fmt/format.h>

namespace plumbline {

FieldSvg::FieldSvg(const FieldSize& field, double margin, double pixelsPerMetre)
    : FieldSvg(field, -Vec2(field.length / 2 + margin, field.width / 2 + margin),
               Vec2(field.length / 2 + margin, field.width / 2 + margin), pixelsPerMetre) {}

std::string FieldSvg::head(double below) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\">\n",
      width(), height() + below);
}

std::string FieldSvg::grass() const {
  return fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#3a7d44\"/>\n", width(), height());
}

std::string FieldSvg::rectangle(const Vec2& from, const Vec2& to, const std::string& style) const {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", x(from.x()),
                     y(to.y()), length(to.x() - from.x()), length(to.y() - from.y()), style);
}

std::string FieldSvg::lines() const {
  const char* line = "fill=\"none\" stroke=\"white\" stroke-width=\"2\"";
  const double goal = field_.length / 2, side = field_.width / 2, front = goal - field_.penaltyDepth,
               area = field_.penaltyWidth / 2;
  const double back = goal + field_.goalDepth, post = field_.goalWidth / 2;
  std::string svg = rectangle({-goal, -side}, {goal, side}, line);
  svg += rectangle({-goal, -area}, {-front, area}, line) + rectangle({front, -area}, {goal, area}, line);
  svg += rectangle({-back, -post}, {-goal, post}, "fill=\"#f2d94e\" fill-opacity=\"0.5\" stroke=\"#f2d94e\"");
  svg += rectangle({goal, -post}, {back, post}, "fill=\"#8ec5ff\" fill-opacity=\"0.5\" stroke=\"#8ec5ff\"");
  svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" {3}/>\n", x(0),
                     y(-side), y(side), line);
  return svg + fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.0f}\" {}/>\n", x(0), y(0),
                           length(field_.centreCircleRadius), line);
}

std::string svgText(double x, double y, const std::string& words, const std::string& style) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, svgEscaped(words));
}

std::string svgEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += static_cast<unsigned char>(c) < ' ' || c == 127 ? ' ' : c;
  }
  return escaped;
}

}  // namespace plumbline
