#include "modules/behavior/SetPieceTaker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(SetPieceTaker)

namespace {

constexpr double farMate = 6;  ///< a mate farther away receives nothing [m]

double distanceToWay(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 1e-9 ? std::clamp((point - from).dot(way) / length, 0.0, 1.0) : 0;
  return (point - from - share * way).norm();
}

}  // namespace

void SetPieceTaker::init() {
  pieces_ = SetPieces(config);
  chosen_ = nullptr;
}

Vec2 SetPieceTaker::at(const SetPiecePlace& place) const {
  return place.at(theBallPos->field, theFieldDimensions->length / 2, side_.onRight());
}

/// How free the ball's way is, less what keeps mates from its end [m].
double SetPieceTaker::worth(const Vec2& end) const {
  double clear = farOpponent, mate = farMate;
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (robot.fallen) continue;
    if (robot.mate)
      mate = std::min(mate, (robot.position - end).norm());
    else
      clear = std::min(clear, distanceToWay(robot.position, theBallPos->field, end));
  }
  return clear - reception * mate;
}

const SetPiecePlace* SetPieceTaker::chooseKick(const SetPiece& piece) {
  const bool known = std::ranges::any_of(piece.kick, [&](const auto& place) { return &place == chosen_; });
  const SetPiecePlace* best = known ? chosen_ : nullptr;
  double most = best ? worth(at(*best)) + changeMargin : 0;
  for (const SetPiecePlace& place : piece.kick)
    if (const double value = worth(at(place)); !best || value > most) {
      best = &place;
      most = value;
    }
  return best;
}

/// Who takes it, where the ball may go with what that is worth, and the choice; or where the player waits.
void SetPieceTaker::draw(const SetPiece& piece, const Vec2& target) const {
  DEBUG_DRAWING("draw:team:setPiece", {
    constexpr std::size_t most = 20;
    const Vec2& own = theRobotPose->pose.position;
    const Vec2& ball = theBallPos->field;
    drawing.line(own, piece.kick.empty() ? target : ball, colours::orange, 2);
    drawing.circle(own, 0.3, colours::orange, 3);
    drawing.text(own, piece.name, colours::orange);
    for (std::size_t i = 0; i < piece.kick.size() && i < most; ++i) {
      const Vec2 end = at(piece.kick[i]);
      drawing.point(end, colours::orange, 6);
      drawing.text(end, fmt::format("{:.1f}", worth(end)), colours::orange);
    }
    if (piece.kick.empty())
      drawing.circle(target, 0.2, colours::orange, 2);
    else
      drawing.arrow(ball, target, colours::orange, 3);
  });
}

void SetPieceTaker::update(SetPieceOutput* theSetPieceOutput) {
  BehaviorOutput& output = *theSetPieceOutput;
  output.clear();
  const SetPiece* piece = pieces_.of(theGameState->playMode);
  output.active = piece && (!piece->kick.empty() || piece->stand) && thePlayerRole->members > 1 &&
                  thePlayerRole->role == PlayerRole::striker && thePlayerRole->mayTouchBall &&
                  theRobotPose->valid && theBallPos->valid && theBallPos->age <= ballMaxAge;
  if (!output.active) {
    chosen_ = nullptr;
    side_ = {};
    return;
  }
  const Vec2& ball = theBallPos->field;
  side_.update(piece, ball);
  if (!piece->kick.empty()) {
    chosen_ = chooseKick(*piece);
    output.skill = Skill::kick;
    output.tolerance = tolerance;
    output.target = Pose2(at(*chosen_));
    draw(*piece, output.target.position);
    return;
  }
  const Vec2 place = at(*piece->stand);
  const Vec2 toBall = ball - place;
  output.skill = Skill::moveToPos;
  output.target = Pose2(place, std::atan2(toBall.y(), toBall.x()));
  draw(*piece, place);
}

}  // namespace plumbline
