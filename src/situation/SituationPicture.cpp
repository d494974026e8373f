#include "situation/SituationPicture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "representations/behavior/Skill.h"
#include "representations/infrastructure/TeamPlayModeNames.h"
#include "situation/ExpectedFile.h"
#include "situation/SituationCanvas.h"

namespace plumbline {
namespace {

constexpr double pictureWidth = 640;               // [pixels]
constexpr double leastWidth = 9, leastHeight = 6;  // that is shown [m]
constexpr double around = 1.3;                     // everybody [m]
constexpr double widest = 2.2, highest = 1.4;      // width in heights
constexpr double longestSector = 5;                // [m]
constexpr std::size_t lineLength = 88;             // of the words [characters]

/// The middle of what is expected of a striker; what goes out of the field ends behind the line.
Vec2 strikersEnd(const Situation& s, const StrikerExpected& e, const FieldSize& field) {
  double radius = 0;
  for (const KickEffect& kick : s.kicks) radius = std::max(radius, kick.distance);
  if (e.reach) radius = std::min(radius, (*e.reach)[1]);
  radius = std::clamp(radius, 1.0, longestSector);
  const double middle = (e.direction[0] + e.direction[1]) / 2;
  const Vec2 direction(std::cos(middle), std::sin(middle));
  const Vec2 lines(field.length / 2, field.width / 2);
  for (const int axis : {0, 1}) {
    const double line = std::copysign(lines[axis] + field.goalDepth, direction[axis]);
    if (std::abs(direction[axis]) > 1e-9)
      radius = std::min(radius, std::max(1.0, (line - s.ball[axis]) / direction[axis]));
  }
  return s.ball + radius * direction;
}

Vec2 middleOf(const std::array<double, 4>& area) {
  return {(area[0] + area[1]) / 2, (area[2] + area[3]) / 2};
}

/// Places that shall be seen besides everybody's.
struct ExpectedPlaces {
  const Situation& s;
  const FieldSize& field;
  std::vector<Vec2> operator()(const std::monostate&) const { return {}; }
  std::vector<Vec2> operator()(const StrikerExpected& e) const { return {strikersEnd(s, e, field)}; }
  std::vector<Vec2> operator()(const GoalieExpected& e) const { return {e.place}; }
  std::vector<Vec2> operator()(const FormationExpected& e) const {
    if (!e.area) return {};
    return {Vec2((*e.area)[0], (*e.area)[2]), Vec2((*e.area)[1], (*e.area)[3])};
  }
  std::vector<Vec2> operator()(const SkillExpected& e) const {
    if (!e.target) return {};
    return {*e.target};
  }
  std::vector<Vec2> operator()(const BlockExpected& e) const {
    if (e.opponent == 0) return {};
    return {e.place};
  }
  std::vector<Vec2> operator()(const CallExpected&) const { return {}; }
};

/// The part of the field in which everybody is, not much wider than high nor the other way round.
FieldSvg windowOf(const Situation& s, const FieldSize& field) {
  std::vector<Vec2> places = std::visit(ExpectedPlaces{s, field}, s.expected);
  places.push_back(s.ball);
  if (s.decides != Decider::block) places.push_back(s.robot.position);
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

struct ExpectedMarks {
  const Situation& s;
  const FieldSize& field;
  SituationCanvas& canvas;
  void operator()(const std::monostate&) const {}
  void operator()(const StrikerExpected& e) const {
    const Vec2 end = strikersEnd(s, e, field);
    const char* actions[] = {"kick or dribble", "kick", "dribble"};
    canvas.sector(s.ball, (end - s.ball).norm(), e.direction[0], e.direction[1]);
    canvas.arrow(s.ball, end);
    canvas.label(end, actions[static_cast<int>(e.action)]);
  }
  void operator()(const GoalieExpected& e) const { goTo(e.place, e.within, "goes here"); }
  void operator()(const FormationExpected& e) const {
    for (const SaidPlace& said : s.team)
      if (said.number == e.striker) {
        canvas.arrow(said.pose.position, s.ball);
        canvas.label(said.pose.position, "to the ball");
      }
    if (e.area) {
      canvas.area({(*e.area)[0], (*e.area)[2]}, {(*e.area)[1], (*e.area)[3]});
      canvas.arrow(s.robot.position, middleOf(*e.area));
    }
    if (e.role != FormationExpected::Role::striker)
      canvas.label(e.area ? middleOf(*e.area) : s.robot.position,
                   e.role == FormationExpected::Role::goalie ? "goalie" : "supporter");
  }
  void operator()(const SkillExpected& e) const {
    if (!e.target) return canvas.label(s.robot.position, e.skill);
    if (e.skill == Skill::kick || e.skill == Skill::dribble) {
      canvas.ring(*e.target, e.within);
      canvas.arrow(s.ball, *e.target);
      return canvas.label(*e.target, e.skill);
    }
    goTo(*e.target, e.within, e.skill);
    if (e.heading)
      canvas.arrow(*e.target, *e.target + 0.8 * Vec2(std::cos(*e.heading), std::sin(*e.heading)));
  }
  void operator()(const BlockExpected& e) const {
    if (e.opponent == 0) return canvas.label(s.ball, "nobody is blocked");
    canvas.ring(e.place, e.within);
    canvas.label(e.place, fmt::format("blocks {}", e.opponent));
  }
  void operator()(const CallExpected& e) const {
    canvas.label(s.ball, e.asks ? "asks for pass mode" : "does not ask");
  }

private:
  void goTo(const Vec2& place, double within, const std::string& words) const {
    canvas.ring(place, within);
    canvas.arrow(s.robot.position, place);
    canvas.label(place, words);
  }
};

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
  if (s.decides != Decider::block) canvas.player(s.robot, s.player, true);
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
  std::visit(ExpectedMarks{s, field, canvas}, s.expected);
  SituationCanvas players(window);
  drawPlayers(s, players);
  std::vector<std::string> lines = linesOf(s.about);
  std::string title = name;
  if (s.mode != TeamPlayMode::playOn) title += fmt::format(" ({})", teamPlayModeName(s.mode));
  const std::string decision = expectedWords(s.expected, s.player);
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
