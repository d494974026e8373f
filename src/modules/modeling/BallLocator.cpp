#include "modules/modeling/BallLocator.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(BallLocator)

void BallLocator::init() {
  BallFilter::Parameters p;
  p.rollingTimeConstant = config.get<double>("rollingTimeConstant", {0.01, 100});
  p.speedNoise = config.get<double>("speedNoise", {1e-4, 100});
  p.touchedSpeedNoise = config.get<double>("touchedSpeedNoise", {1e-4, 100});
  p.startSpeedDeviation = config.get<double>("startSpeedDeviation", {1e-3, 100});
  p.restDeviations = config.get<double>("restDeviations", {0, 100});
  p.gate = config.get<double>("gate", {0.1, 100});
  p.agreementSpeed = config.get<double>("agreementSpeed", {0, 100});
  p.agreementSeconds = config.get<double>("agreementSeconds", {0, 100});
  filter_ = BallFilter(p);
  distanceShare_ = config.get<double>("distanceShare", {0, 1});
  distanceNoise_ = config.get<double>("distanceNoise", {1e-6, 1});
  angleNoise_ = config.get<double>("angleNoise", {1e-6, 1});
  stepShare_ = config.get<double>("stepShare", {0, 1});
  touchDistance_ = config.get<double>("touchDistance", {0, 10});
  forgetSeconds_ = config.get<double>("forgetSeconds", {0, 1e4});
  viewAngle_ = config.get<double>("viewAngle", {0, 1.5});
  missedImages_ = config.get<int>("missedImages", {1, 10000});
}

Mat2 BallLocator::perceptCovariance(const Vec2& position) const {
  const double distance = position.norm();
  const Vec2 along = distance > 1e-6 ? Vec2(position / distance) : Vec2(Vec2::UnitX());
  const Vec2 across(-along.y(), along.x());
  const double a = distanceNoise_ + distanceShare_ * distance, b = distanceNoise_ + angleNoise_ * distance;
  return a * a * along * along.transpose() + b * b * across * across.transpose();
}

/// Whether the tracked ball, lying on the ground, is well inside the picture.
bool BallLocator::shouldBeInView() const {
  const Vec2 relative = theOdometry->total.inverse() * filter_.position();
  const Pose3 T_head_ground = (theTorsoPose->T_ground_torso * theFKModel->T_torso_head).inverse();
  const Vec3 p = T_head_ground * Vec3(relative.x(), relative.y(), 0);
  const double reach = std::tan(viewAngle_) * p.x();
  return theTorsoPose->valid && std::abs(p.y()) < reach && std::abs(p.z()) < reach;
}

void BallLocator::see(LocalBallPos& ball) {
  if (theBallPercept->seen) {
    const Mat2 turn = theOdometry->total.rotation();
    const Mat2 covariance = turn * perceptCovariance(theBallPercept->position) * turn.transpose();
    filter_.update(theOdometry->total * theBallPercept->position, covariance);
    lastSeen_ = ball.lastSeen = theFrameInfo->time;
    missed_ = 0;
    valid_ = true;
  } else if (valid_ && shouldBeInView()) {
    if (++missed_ >= missedImages_) valid_ = false;
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
    filter_.predict(theFrameInfo->cycleSeconds, relative.norm() < touchDistance_,
                    stepShare_ * theOdometry->step.position.norm());
  }
  if (theVisionInfo->newImage) see(*theLocalBallPos);
  if (theFrameInfo->time - lastSeen_ > forgetSeconds_) valid_ = false;
  theLocalBallPos->valid = valid_;
  if (!filter_.started()) return;
  theLocalBallPos->position = theOdometry->total.inverse() * filter_.position();
  theLocalBallPos->velocity = theOdometry->total.rotation().transpose() * filter_.velocity();
  theLocalBallPos->deviation = filter_.deviation();
}

}  // namespace plumbline
