#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "framework/ConfigFile.h"
#include "math/Pose2.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "support/Robots.h"

namespace plumbline::test {

/// A file of tests/data/situations/: places in the team's frame and the decision that people expect [m, rad].
inline ConfigFile situationFile(const std::string& name) {
  return ConfigFile("tests/data/situations/" + name + ".yaml");
}

inline Pose2 poseOf(const ConfigSection& section, const char* key) {
  const Vec3 pose = section.get<Vec3>(key);
  return {pose.x(), pose.y(), pose.z()};
}

/// mates and opponents, [x, y] each, or the uniform number as well: [x, y, number].
inline std::vector<OtherRobot> othersOf(const ConfigSection& root) {
  std::vector<OtherRobot> others;
  for (const bool mate : {true, false})
    for (const auto& entry : root.get<std::vector<std::vector<double>>>(mate ? "mates" : "opponents")) {
      if (entry.size() != 2 && entry.size() != 3) root.fail(mate ? "mates" : "opponents", "has no [x, y]");
      addRobot(others, mate, {entry[0], entry[1]}, entry.size() > 2 ? static_cast<int>(entry[2]) : 0);
    }
  return others;
}

/// A ball that rests and is in sight, as the robot at `pose` believes it.
inline void placeBall(BallPos& ball, const Pose2& pose, const Vec2& place) {
  ball.valid = true;
  ball.age = 0;
  ball.field = place;
  ball.relative = pose.inverse() * place;
}

/// The key `mode`; missing: play is on.
inline PlayMode modeOf(const ConfigSection& root) {
  const std::vector<std::pair<std::string, PlayMode>> modes{{"playOn", PlayMode::playOn},
                                                            {"kickOffOwn", PlayMode::kickOffOwn},
                                                            {"kickInOwn", PlayMode::kickInOwn},
                                                            {"goalKickOwn", PlayMode::goalKickOwn},
                                                            {"cornerOwn", PlayMode::cornerOwn},
                                                            {"freeKickOwn", PlayMode::freeKickOwn},
                                                            {"passOwn", PlayMode::passOwn},
                                                            {"kickOffOpponent", PlayMode::kickOffOpponent},
                                                            {"kickInOpponent", PlayMode::kickInOpponent}};
  if (!root.has("mode")) return PlayMode::playOn;
  std::vector<std::string> names;
  for (const auto& [name, mode] : modes) names.push_back(name);
  return modes[root.choice("mode", names)].second;
}

/// Gives a module's harness the play mode, the robot, the ball and the other robots of a situation.
template <class Harness>
void placeScene(Harness& harness, const ConfigSection& root) {
  const Pose2 robot = poseOf(root, "robot");
  harness.template input<GameState>().playMode = modeOf(root);
  harness.template input<RobotPose>().pose = robot;
  placeBall(harness.template input<BallPos>(), robot, root.get<Vec2>("ball"));
  harness.template input<OtherRobots>().robots = othersOf(root);
}

}  // namespace plumbline::test
