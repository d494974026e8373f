#pragma once
#include <string>

#include "field/FieldSvg.h"
#include "math/Pose2.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// The marks of which pictures of situations are made; places in metres.
class SituationCanvas {
public:
  explicit SituationCanvas(const FieldSvg& field) : field_(field) {}

  /// A mate or opponent of which no heading is known.
  void player(bool mate, const Vec2& place, int number);
  /// The line from its middle shows its heading.
  void player(const Pose2& pose, int number, bool decides);
  void ball(const Vec2& place);
  /// Where something goes by itself: dashed.
  void motion(const Vec2& from, const Vec2& to, const char* colour);
  /// What is expected: an arrow, a place within which it shall be, a sector of directions, a part of the
  /// field, words.
  void arrow(const Vec2& from, const Vec2& to);
  void ring(const Vec2& place, double radius);
  void sector(const Vec2& from, double radius, double least, double most);
  void area(const Vec2& from, const Vec2& to);
  void label(const Vec2& place, const std::string& words);
  /// The player shall go to a place: arrow, ring and words.
  void way(const Vec2& from, const Vec2& place, double within, const std::string& words);

  const std::string& svg() const { return svg_; }

  static constexpr const char* own = "#2f6fe8";
  static constexpr const char* opponent = "#d63a2f";
  static constexpr const char* ballColour = "#ff8c1a";
  static constexpr const char* expected = "#ffe14a";

private:
  void disc(const Vec2& pixels, const char* colour, int number);
  void line(const Vec2& from, const Vec2& to, const std::string& style, const char* colour);

  FieldSvg field_;
  std::string svg_;
};

}  // namespace plumbline
