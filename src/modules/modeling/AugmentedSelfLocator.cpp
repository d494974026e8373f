#include "modules/modeling/AugmentedSelfLocator.h"

namespace plumbline {

MAKE_MODULE(AugmentedSelfLocator)

void AugmentedSelfLocator::init() {
  PoseFilter::Parameters& p = parameters_;
  p.particles = config.get<int>("particles", {1, 10000});
  p.seed = config.get<unsigned>("seed");
  p.slowRate = config.get<double>("slowRate", {0, 1});
  p.fastRate = config.get<double>("fastRate", {p.slowRate, 1});
  p.stepShare = config.get<double>("stepShare", {0, 1});
  p.stepNoise = config.get<double>("stepNoise", {1e-6, 1});
  p.turnShare = config.get<double>("turnShare", {0, 1});
  p.turnNoise = config.get<double>("turnNoise", {1e-6, 1});
  p.validDeviation = config.get<double>("validDeviation", {0, 100});
  p.validHeadingDeviation = config.get<double>("validHeadingDeviation", {0, 10});
  const ConfigSection vision = config.section("vision");
  noise_.distanceShare = vision.get<double>("distanceShare", {0, 1});
  noise_.distance = vision.get<double>("distance", {1e-6, 1});
  noise_.azimuth = vision.get<double>("azimuth", {1e-6, 1});
  noise_.elevation = vision.get<double>("elevation", {1e-6, 1});
  noise_.offset = vision.get<double>("offset", {0, 1});
  noise_.tilt = vision.get<double>("tilt", {0, 1});
  view_.landmarks.reserve(FieldMap::numLandmarks);
  view_.lines.reserve(FieldMap::numSegments);
}

void AugmentedSelfLocator::start() {
  const FieldDimensions& field = *theFieldDimensions;
  leftSide_ = thePlayerInfo->leftSide;
  filter_.emplace(FieldMap({field.length, field.width, field.goalWidth, field.penaltyDepth,
                            field.penaltyWidth, field.centreCircleRadius},
                           leftSide_),
                  parameters_);
}

void AugmentedSelfLocator::look() {
  const Pose3 T_ground_head = theTorsoPose->T_ground_torso * theFKModel->T_torso_head;
  const auto project = [&](const PolarPoint& point) {
    return projectToGround(point.distance, point.azimuth, point.elevation, T_ground_head, noise_);
  };
  view_.landmarks.clear();
  for (const PolarLandmark& seen : thePolarLandmarkPercept->landmarks)
    if (const int index = FieldMap::landmarkIndex(seen.name); index >= 0)
      view_.landmarks.push_back({index, project(seen.position)});
  view_.lines.clear();
  for (const PolarLine& seen : thePolarLinePercept->lines)
    view_.lines.push_back({project(seen.a), project(seen.b), !atImageBorder(seen.a.azimuth, seen.a.elevation),
                           !atImageBorder(seen.b.azimuth, seen.b.elevation)});
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
  const PoseFilter::Estimate& estimate = filter_->estimate();
  theRobotPose->pose = estimate.pose;
  theRobotPose->positionDeviation = estimate.positionDeviation;
  theRobotPose->headingDeviation = estimate.headingDeviation;
  theRobotPose->valid = estimate.valid && thePlayerInfo->sideKnown;
}

}  // namespace plumbline
