#include "watch/LearnFromTrack.h"

#include <gtest/gtest.h>

using namespace plumbline;
using namespace plumbline::watch;

namespace {

struct LearnFromTrackTest : testing::Test {
  /// Two moments a second from time on; one player of each team, the left one `nearer` to the ball [m].
  void play(double begin, double end, const std::string& mode, double x) {
    for (double time = begin; time < end; time += 0.5)
      moments.push_back(
          {time, mode, Vec2(x, 0), {{true, 1, Vec2(x - 1, 0), true}, {false, 1, Vec2(x + 4, 0), true}}});
  }
  FieldValueLearner learner{FieldGrid({-10, 0, 10}, {0, 5}), {}};
  std::vector<TrackMoment> moments;
};

TEST_F(LearnFromTrackTest, aStepForEachMomentThreeSecondsBeforeAnother) {
  play(0, 10, "PlayOn", 2);
  EXPECT_EQ(learnFromTrack(moments, learner), 14u);  // 20 moments, the last six have none
  EXPECT_EQ(learner.goals(), 0u);
}

TEST_F(LearnFromTrackTest, aGoalEndsTheStepsBeforeIt) {
  play(0, 2, "PlayOn", 9);
  play(2, 4, "Goal_Left", 10);
  play(4, 10, "KickOff_Right", 0);
  EXPECT_EQ(learnFromTrack(moments, learner), 4u);
  EXPECT_EQ(learner.goals(), 4u);
  EXPECT_GT(learner.learn().at({{9, 0}, 1}), 0.5);
}

TEST_F(LearnFromTrackTest, nothingFollowsOverAPauseOrAKickOff) {
  play(0, 2, "PlayOn", 1);
  play(20, 22, "PlayOn", 1);
  play(22, 24, "KickOff_Left", 0);
  EXPECT_EQ(learnFromTrack(moments, learner), 0u);
}

TEST_F(LearnFromTrackTest, outOfPlayTheBallIsTheirsWhoBringItIn) {
  play(0, 1, "PlayOn", 5);
  play(1, 6, "KickIn_Right", 5);
  play(6, 7, "Goal_Right", 5);
  EXPECT_EQ(learnFromTrack(moments, learner), 12u);
  EXPECT_LT(learner.learn().at({{5, 0}, -1}), learner.learn().at({{5, 0}, 1}));
}

}  // namespace
