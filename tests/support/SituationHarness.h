#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "situation/SituationFile.h"
#include "situation/SituationKind.h"

namespace plumbline::test {

/// The names of the situations in tests/data/situations/DECIDER, for INSTANTIATE_TEST_SUITE_P.
inline std::vector<std::string> situationNames(const std::string& decider) {
  std::vector<std::string> names;
  std::error_code none;  // a test without a situation fails by itself
  for (const auto& entry : std::filesystem::directory_iterator("tests/data/situations/" + decider, none))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

inline std::string situationName(const testing::TestParamInfo<std::string>& info) { return info.param; }

/// One of them. A failure while it lives says how to draw it.
template <typename E>
class WrittenSituation {
public:
  WrittenSituation(const std::string& decider, const std::string& name)
      : file_("tests/data/situations/" + decider + "/" + name + ".yaml"),
        situation_(readSituation(file_)),
        trace_(file_.c_str(), 1, "to see it: bin/situations draw " + file_) {
    if (situation_.kind->traits.name != decider)
      throw std::runtime_error(file_ + ": it is not decided by what its folder says");
    if (!expectedOf<E>(situation_))
      throw std::runtime_error(file_ + ": it has no `expected`: write what you expect");
  }
  const Situation& operator*() const { return situation_; }
  const Situation* operator->() const { return &situation_; }
  const E& expected() const { return *expectedOf<E>(situation_); }

private:
  std::string file_;
  Situation situation_;
  testing::ScopedTrace trace_;
};

/// A ball that rests and is in sight, as the robot at `pose` believes it.
inline void placeBall(BallPos& ball, const Pose2& pose, const Vec2& place) {
  ball.valid = true;
  ball.age = 0;
  ball.field = place;
  ball.relative = pose.inverse() * place;
}

/// Gives a module's harness the play mode, the robot, the ball and the other robots of a situation.
template <class Harness>
void placeScene(Harness& harness, const Situation& situation) {
  harness.template input<GameState>().playMode = situation.mode;
  harness.template input<RobotPose>().pose = situation.robot;
  placeBall(harness.template input<BallPos>(), situation.robot, situation.ball);
  harness.template input<OtherRobots>().robots = situation.others;
}

}  // namespace plumbline::test
