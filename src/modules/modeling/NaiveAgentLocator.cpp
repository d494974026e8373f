#include "modules/modeling/NaiveAgentLocator.h"

#include <algorithm>
#include <cmath>

#include "field/TeamSize.h"
#include "framework/DrawingSite.h"
#include "modules/modeling/others/RobotDrawing.h"

namespace plumbline {

MAKE_MODULE(NaiveAgentLocator)

namespace {
constexpr double sameRobot = 1.0;  ///< how far a sight without a number may be from a track [m]
}  // namespace

RobotTrack* NaiveAgentLocator::trackOf(bool mate, int number, const Vec2& position) {
  if (!isUniformNumber(number)) {
    RobotTrack* nearest = nullptr;
    double best = sameRobot;
    for (RobotTrack& track : tracks_) {
      const double distance = (track.robot().position - position).norm();
      if (track.robot().mate != mate || distance > best) continue;
      best = distance;
      nearest = &track;
    }
    return nearest;
  }
  for (RobotTrack& track : tracks_)
    if (track.robot().mate == mate && track.robot().number == number) return &track;
  return &tracks_.emplace_back(mate, number);
}

void NaiveAgentLocator::see(const Pose3& T_ground_head) {
  const Pose2& own = theRobotPose->pose;
  const Mat2 turn = own.rotation();
  for (const PolarPlayer& player : thePolarPlayerPercept->players) {
    const bool mate = player.team == thePlayerInfo->team;
    if (mate && player.number == thePlayerInfo->number) continue;  // the own arms
    const auto view = viewBody(player, T_ground_head, body);
    if (!view) continue;
    const Vec2 position = own * view->position;
    RobotTrack* track = trackOf(mate, player.number, position);
    if (!track) continue;
    Mat2 covariance = turn * view->covariance * turn.transpose();
    const double spread = headingNoise * view->position.norm();
    covariance.diagonal().array() += spread * spread;
    track->see(position, covariance, theFrameInfo->time, this->track);
    if (view->postureKnown) track->setFallen(view->fallen);
  }
}

bool NaiveAgentLocator::shouldBeInView(const RobotTrack& track, const Pose3& T_head_ground) const {
  const Vec2 relative = theRobotPose->pose.inverse() * track.robot().position;
  const Vec3 p = T_head_ground * Vec3(relative.x(), relative.y(), 0.3);
  const double reach = std::tan(viewAngle) * p.x();
  return std::abs(p.y()) < reach && std::abs(p.z()) < reach;
}

bool NaiveAgentLocator::hidden(const RobotTrack& track) const {
  const Vec2 way = track.robot().position - theRobotPose->pose.position;
  return std::ranges::any_of(tracks_, [&](const RobotTrack& other) {
    if (&other == &track || other.robot().lastSeen < theFrameInfo->time) return false;
    const Vec2 otherWay = other.robot().position - theRobotPose->pose.position;
    const double along = otherWay.dot(way), across = otherWay.x() * way.y() - otherWay.y() * way.x();
    return otherWay.norm() < way.norm() && std::abs(std::atan2(across, along)) < coverAngle;
  });
}

void NaiveAgentLocator::miss(const Pose3& T_ground_head) {
  const Pose3 T_head_ground = T_ground_head.inverse();
  for (RobotTrack& track : tracks_) {
    if (track.robot().lastSeen >= theFrameInfo->time) continue;
    if (shouldBeInView(track, T_head_ground) && !hidden(track)) ++track.missed;
  }
}

void NaiveAgentLocator::update(LocalOtherRobots* theLocalOtherRobots) {
  if (theFrameInfo->restarted) tracks_.clear();
  for (RobotTrack& one : tracks_) one.predict(theFrameInfo->cycleSeconds, track);
  // Where the robot itself is not known, nothing can be placed on the field.
  if (theVisionInfo->newImage && theTorsoPose->valid && theRobotPose->valid) {
    const Pose3 T_ground_head = theTorsoPose->T_ground_torso * theFKModel->T_torso_head;
    see(T_ground_head);
    miss(T_ground_head);
  }
  std::erase_if(tracks_, [&](const RobotTrack& one) {
    return one.missed >= missedImages || theFrameInfo->time - one.robot().lastSeen > forgetSeconds;
  });
  theLocalOtherRobots->robots.clear();
  for (const RobotTrack& one : tracks_) theLocalOtherRobots->robots.push_back(one.robot());
  DEBUG_DRAWING("draw:belief:sight", drawRobots(drawing, theLocalOtherRobots->robots, beliefColours::sight));
}

}  // namespace plumbline
