#include "modules/modeling/BallLocator.h"

#include <cmath>

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(BallLocator)

void BallLocator::parametersChanged() { filter_.setParameters(filter); }

Mat2 BallLocator::perceptCovariance(const Vec2& position) const {
  const double distance = position.norm();
  const Vec2 along = distance > 1e-6 ? Vec2(position / distance) : Vec2(Vec2::UnitX());
  const Vec2 across(-along.y(), along.x());
  const double a = distanceNoise + distanceShare * distance, b = distanceNoise + angleNoise * distance;
  return a * a * along * along.transpose() + b * b * across * across.transpose();
}

/// Whether the tracked ball, lying on the ground, is well inside the picture.
bool BallLocator::shouldBeInView() const {
  const Vec2 relative = theOdometry->total.inverse() * filter_.position();
  const Pose3 T_head_ground = (theTorsoPose->T_ground_torso * theFKModel->T_torso_head).inverse();
  const Vec3 p = T_head_ground * Vec3(relative.x(), relative.y(), 0);
  const double reach = std::tan(viewAngle) * p.x();
  return theTorsoPose->valid && std::abs(p.y()) < reach && std::abs(p.z()) < reach;
}

void BallLocator::see(LocalBallPos& ball) {
  if (theBallPercept->seen) {
    // Where a lost ball lay means nothing: one that the filter had not confirmed would be believed there
    // again, and the robot would turn away from the ball that it sees.
    if (!valid_) filter_.reset();
    const Mat2 turn = theOdometry->total.rotation();
    const Mat2 covariance = turn * perceptCovariance(theBallPercept->position) * turn.transpose();
    filter_.update(theOdometry->total * theBallPercept->position, covariance);
    lastSeen_ = ball.lastSeen = theFrameInfo->time;
    missed_ = 0;
    valid_ = true;
  } else if (valid_ && shouldBeInView()) {
    if (++missed_ >= missedImages) valid_ = false;
  }
}

void BallLocator::update(LocalBallPos* theLocalBallPos) {
  if (theFrameInfo->restarted) {
    filter_.reset();
    valid_ = false;
    lastSeen_ = theLocalBallPos->lastSeen = -1;
  }
  if (filter_.started()) {
    const Vec2 relative = theOdometry->total.inverse() * filter_.position();
    filter_.predict(theFrameInfo->cycleSeconds, relative.norm() < touchDistance,
                    stepShare * theOdometry->step.position.norm());
  }
  if (theVisionInfo->newImage) see(*theLocalBallPos);
  if (theFrameInfo->time - lastSeen_ > forgetSeconds) valid_ = false;
  theLocalBallPos->valid = valid_;
  DEBUG_RESPONSE_ONCE("module:BallLocator:forget", filter_.reset();
                      DEBUG_RESPONSE_OUTPUT("the ball is forgotten"));
  if (!filter_.started()) return;
  OUTPUT_BY_VALUE("module:BallLocator:onField", filter_.position());
  theLocalBallPos->position = theOdometry->total.inverse() * filter_.position();
  theLocalBallPos->velocity = theOdometry->total.rotation().transpose() * filter_.velocity();
  theLocalBallPos->deviation = filter_.deviation();
  DEBUG_DRAWING("draw:BallLocator:ball", {
    const LocalBallPos& ball = *theLocalBallPos;
    const shapes::Colour colour = ball.valid ? colours::orange : colours::faint(colours::orange, 0.4);
    drawing.in(DrawingFrame::robot);
    drawing.sphere(Vec3(ball.position.x(), ball.position.y(), 0.042), 0.05, colour);
    const Mat2 turn = theOdometry->total.rotation();
    drawing.ellipse(ball.position, turn.transpose() * filter_.covariance() * turn, colour, 2, 1);
    drawing.arrow(ball.position, Vec2(ball.position + ball.velocity), colour);
    if (theBallPercept->seen) drawing.point(theBallPercept->position, colours::red, 6);
  });
}

}  // namespace plumbline
