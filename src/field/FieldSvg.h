#pragma once
#include <string>

#include "field/FieldSize.h"
#include "math/Types.h"

namespace plumbline {

/// A part of the field from above as an SVG picture: which pixels a place has, and the lines of the field.
class FieldSvg {
public:
  /// What is seen: from the lower left to the upper right corner [m].
  FieldSvg(const FieldSize& field, const Vec2& from, const Vec2& to, double pixelsPerMetre)
      : field_(field), from_(from), to_(to), scale_(pixelsPerMetre) {}
  /// All of it with a margin [m].
  FieldSvg(const FieldSize& field, double margin, double pixelsPerMetre);

  double x(double metres) const { return scale_ * (metres - from_.x()); }
  double y(double metres) const { return scale_ * (to_.y() - metres); }
  Vec2 pixels(const Vec2& place) const { return {x(place.x()), y(place.y())}; }
  double length(double metres) const { return scale_ * metres; }
  double width() const { return scale_ * (to_.x() - from_.x()); }
  double height() const { return scale_ * (to_.y() - from_.y()); }

  /// The picture's first line, with room for text of that height below the field [pixels].
  std::string head(double below) const;
  std::string grass() const;
  std::string lines() const;
  /// Between two corners [m].
  std::string rectangle(const Vec2& from, const Vec2& to, const std::string& style) const;

private:
  FieldSize field_;
  Vec2 from_, to_;
  double scale_;
};

/// A line of text at a place [pixels]; any characters.
std::string svgText(double x, double y, const std::string& words, const std::string& style);

/// What stands for these characters in SVG; control characters become blanks.
std::string svgEscaped(const std::string& text);

}  // namespace plumbline
