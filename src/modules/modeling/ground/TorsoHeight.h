#pragma once
#include <span>
#include <vector>

#include "robot/RobotModel.h"

namespace plumbline {

/// How high the torso's centre is above flat ground, given up in the torso frame and where the links are.
class TorsoHeight {
public:
  explicit TorsoHeight(const RobotModel& model);

  /// Above the lowest point of feet and toes, the links that an ankle's roll or a toe's pitch moves [m]. A
  /// robot without ankles stands on whatever of it is lowest. up: unit, torso frame; T_torso_link: one per
  /// link.
  double aboveFeet(const Vec3& up, std::span<const Pose3> T_torso_link) const;
  /// Above the lowest point of all bodies that collide: for a robot that lies [m].
  double aboveLowestPoint(const Vec3& up, std::span<const Pose3> T_torso_link) const;

private:
  struct Body {
    std::size_t link;
    Shape shape;
  };
  static double height(const std::vector<Body>& bodies, const Vec3& up, std::span<const Pose3> T_torso_link);
  std::vector<Body> feet_, all_;
};

}  // namespace plumbline
