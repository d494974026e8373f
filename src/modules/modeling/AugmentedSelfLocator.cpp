#include "modules/modeling/AugmentedSelfLocator.h"

#include <cmath>

#include "framework/DrawingSite.h"

namespace plumbline {

MAKE_MODULE(AugmentedSelfLocator)

void AugmentedSelfLocator::parametersChanged() {
  if (filter.fastRate < filter.slowRate) refuse("filter.fastRate", "must not be below filter.slowRate");
  if (filter_) filter_->setParameters(filter);
}

void AugmentedSelfLocator::init() {
  view_.landmarks.reserve(FieldMap::numLandmarks);
  view_.lines.reserve(FieldMap::numSegments);
}

void AugmentedSelfLocator::start() {
  leftSide_ = thePlayerInfo->leftSide;
  filter_.emplace(FieldMap(theFieldDimensions->size(), leftSide_), filter);
}

void AugmentedSelfLocator::look() {
  const Pose3 T_ground_head = theTorsoPose->T_ground_torso * theFKModel->T_torso_head;
  const auto project = [&](const PolarPoint& point) {
    return projectToGround(point.distance, point.azimuth, point.elevation, T_ground_head, vision);
  };
  view_.landmarks.clear();
  for (const PolarLandmark& seen : thePolarLandmarkPercept->landmarks)
    if (const int index = FieldMap::landmarkIndex(seen.name); index >= 0)
      view_.landmarks.push_back({index, project(seen.position)});
  view_.lines.clear();
  const double border = std::tan(vision.imageBorder);
  for (const PolarLine& seen : thePolarLinePercept->lines)
    view_.lines.push_back({project(seen.a), project(seen.b),
                           !atImageBorder(seen.a.azimuth, seen.a.elevation, border),
                           !atImageBorder(seen.b.azimuth, seen.b.elevation, border)});
}

void AugmentedSelfLocator::drawSeen(Drawing& drawing) const {
  drawing.in(DrawingFrame::field, filter_->estimate().pose);
  for (const SeenFieldLine& line : view_.lines)
    drawing.line(line.a.position, line.b.position, colours::violet, 3);
  for (const SeenLandmark& landmark : view_.landmarks) {
    const Vec2& place = landmark.point.position;
    drawing.line(Vec2(0, 0), place, colours::violet, 1);
    drawing.point(Vec3(place.x(), place.y(), landmark.point.height), colours::violet, 8);
  }
}

void AugmentedSelfLocator::update(RobotPose* theRobotPose) {
  if (!filter_ || leftSide_ != thePlayerInfo->leftSide) start();
  if (theFrameInfo->restarted) filter_->reset();
  filter_->predict(theOdometry->step, theFallState->posture != Posture::upright);
  if (theVisionInfo->newImage) {
    const auto watch = debug.stopwatch("image");
    look();
    filter_->update(view_);
  }
  DEBUG_RESPONSE_ONCE("module:AugmentedSelfLocator:forget", filter_->reset();
                      DEBUG_RESPONSE_OUTPUT("the pose is forgotten"));
  OUTPUT_BY_VALUE("module:AugmentedSelfLocator:particles", filter_->particleCount());
  OUTPUT_BY_VALUE("module:AugmentedSelfLocator:resets", filter_->resets());
  DEBUG_DRAWING("draw:AugmentedSelfLocator:particles", {
    for (const PoseFilter::Particle& one : filter_->believed()) {
      const double deviation = std::sqrt(one.belief.covariance.topLeftCorner<2, 2>().trace() / 2);
      drawing.circle(one.belief.pose.position, deviation, colours::yellow, 1);
      drawing.pose(one.belief.pose, 0.2, colours::yellow, 1);
    }
  });
  DEBUG_DRAWING("draw:AugmentedSelfLocator:seen", drawSeen(drawing));
  const PoseFilter::Estimate& estimate = filter_->estimate();
  theRobotPose->pose = estimate.pose;
  theRobotPose->positionDeviation = estimate.positionDeviation;
  theRobotPose->headingDeviation = estimate.headingDeviation;
  theRobotPose->valid = estimate.valid && thePlayerInfo->sideKnown;
}

}  // namespace plumbline
