#pragma once
#include <vector>

#include "framework/Representation.h"
#include "representations/communication/TeamBelief.h"
#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// The last words of one player.
struct TeamReport : public Streamable {
  TeamBelief belief;
  double time = -1;  ///< FrameInfo time when it was heard [s]
  void stream(InStream* in, OutStream* out) override {
    STREAM(belief);
    STREAM(time);
  }
};

/// The last message of every mate heard recently, and the own one, by number. All players of a team have the
/// same data, except for lost messages.
REPRESENTATION(TeamRobotPose)
class TeamRobotPose : public TeamRobotPoseBase {
public:
  std::vector<TeamReport> reports;
  const TeamReport* of(int number) const {
    for (const TeamReport& report : reports)
      if (report.belief.number == number) return &report;
    return nullptr;
  }
  void stream(InStream* in, OutStream* out) override { STREAM(reports); }
};

/// The ball as mates tell of it, weighted by their certainty [m, m/s].
REPRESENTATION(TeamBallPos)
class TeamBallPos : public TeamBallPosBase {
public:
  bool valid = false;
  Vec2 field = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  double deviation = 10;  ///< per axis [m]
  double age = 1e3;       ///< since any of them saw it [s]
  void stream(InStream* in, OutStream* out) override {
    STREAM(valid);
    STREAM(field);
    STREAM(velocity);
    STREAM(deviation);
    STREAM(age);
  }
};

/// Mates by their own words, and opponents by those of mates; lastSeen is when it was heard.
REPRESENTATION(TeamOtherRobots)
class TeamOtherRobots : public TeamOtherRobotsBase {
public:
  std::vector<OtherRobot> robots;
  void stream(InStream* in, OutStream* out) override { STREAM(robots); }
};

}  // namespace plumbline
