#include "situation/SituationPicture.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/SituationCanvas.h"
#include "situation/SituationKind.h"

namespace plumbline {
namespace {

constexpr double pictureWidth = 640;               // [pixels]
constexpr double leastWidth = 9, leastHeight = 6;  // that is shown [m]
constexpr double around = 1.3;                     // everybody [m]
constexpr double widest = 2.2, highest = 1.4;      // width in heights
constexpr std::size_t lineLength = 88;             // of the words [characters]

/// The part of the field in which everybody is, not much wider than high nor the other way round.
FieldSvg windowOf(const Situation& s, const FieldSize& field) {
  std::vector<Vec2> places;
  if (s.expected) places = s.expected->places(s, field);
  places.push_back(s.ball);
  if (s.kind->traits.ofOnePlayer) places.push_back(s.robot.position);
  if (s.place) places.push_back(s.place->position);
  for (const OtherRobot& robot : s.others) places.push_back(robot.position);
  for (const PlacedPlayer& player : s.going) places.push_back(player.place.position);
  for (const SaidPlace& said : s.team) places.push_back(said.pose.position);
  Vec2 from = places.front(), to = from;
  for (const Vec2& place : places) {
    from = from.cwiseMin(place);
    to = to.cwiseMax(place);
  }
  const Vec2 whole(field.length / 2 + around, field.width / 2 + around);
  Vec2 size = (to - from + Vec2(2 * around, 2 * around)).cwiseMax(Vec2(leastWidth, leastHeight));
  size.x() = std::max(size.x(), highest * size.y());
  size.y() = std::max(size.y(), size.x() / widest);
  // Near the border the middle moves inwards: beyond it there is nothing to see.
  const Vec2 room = (whole - size / 2).cwiseMax(Vec2::Zero());
  const Vec2 outside = ((to - from) / 2 + Vec2(around, around) - size / 2).cwiseMax(Vec2::Zero());
  const Vec2 middle = ((from + to) / 2).cwiseMin(room + outside).cwiseMax(-room - outside);
  return {field, middle - size / 2, middle + size / 2, pictureWidth / size.x()};
}

void drawMotion(const Situation& s, SituationCanvas& canvas) {
  canvas.motion(s.ball, s.ball + s.ballVelocity, SituationCanvas::ballColour);
  for (const OtherRobot& robot : s.others)
    canvas.motion(robot.position, robot.position + robot.velocity,
                  robot.mate ? SituationCanvas::own : SituationCanvas::opponent);
  std::size_t i = 0;  // mates come first
  for (const PlacedPlayer& player : s.going)
    canvas.motion(s.others.at(i++).position, player.place.position, SituationCanvas::own);
  if (s.place) canvas.motion(s.robot.position, s.place->position, SituationCanvas::own);
}

void drawPlayers(const Situation& s, SituationCanvas& canvas) {
  for (std::size_t i = 0; i < s.others.size(); ++i) {
    const OtherRobot& robot = s.others[i];
    if (i < s.going.size())
      canvas.player(Pose2(robot.position, s.going[i].heading), robot.number, false);
    else
      canvas.player(robot.mate, robot.position, robot.number);
  }
  for (const SaidPlace& said : s.team)
    if (said.number != s.player) canvas.player(said.pose, said.number, false);
  if (s.kind->traits.ofOnePlayer) canvas.player(s.robot, s.player, true);
  canvas.ball(s.ball);
}

/// Words in lines that fit below the picture.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > lineLength)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  }
  return lines;
}

}  // namespace

std::string situationPicture(const Situation& s, const std::string& name, const FieldSize& field) {
  const FieldSvg window = windowOf(s, field);
  SituationCanvas canvas(window);
  drawMotion(s, canvas);
  if (s.expected) s.expected->draw(s, field, canvas);
  SituationCanvas players(window);
  drawPlayers(s, players);
  std::vector<std::string> lines = linesOf(s.about);
  std::string title = name;
  if (s.mode != TeamPlayMode::playOn) title += fmt::format(" ({})", teamPlayModeName(s.mode));
  const std::string decision = expectedWords(s);
  lines.push_back("expected: " + (decision.empty() ? "not written yet" : decision));
  constexpr double lineHeight = 18;
  std::string svg = window.head(lineHeight * static_cast<double>(lines.size() + 1) + 12);
  // What is outside must not be drawn over the words.
  svg += fmt::format("<svg width=\"{:.0f}\" height=\"{:.0f}\">\n", window.width(), window.height());
  svg += window.grass() + window.lines() + canvas.svg() + players.svg() + "</svg>\n";
  double y = window.height() + lineHeight;
  svg += svgText(8, y, title, "font-size=\"13\" font-weight=\"bold\"");
  for (const std::string& line : lines) svg += svgText(8, y += lineHeight, line, "font-size=\"13\"");
  return svg + "</svg>\n";
}

}  // namespace plumbline
