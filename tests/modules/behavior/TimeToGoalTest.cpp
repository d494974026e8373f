#include "modules/behavior/striker/TimeToGoal.h"

#include <gtest/gtest.h>

using namespace plumbline;

namespace {

/// A robot alone, and kicks that hit without fail.
struct TimeToGoalTest : testing::Test {
  static KickEffect kick(double distance) {
    return {.distance = distance, .scatter = 1e-3, .spread = 1e-2, .rise = 0};
  }
  double seconds(double distance) const { return TimeToGoal(situation, time, choice).seconds(distance); }

  StrikerSituation situation;
  const TimeToBallParameters time;
  const ActionChoiceParameters choice;
};

TEST_F(TimeToGoalTest, withoutKicksItDribbles) {
  EXPECT_NEAR(seconds(6), choice.pushSeconds + 6 / choice.dribbleSpeed, 1e-9);
}

TEST_F(TimeToGoalTest, aSureShotIsAKick) {
  situation.kicks = {kick(9)};
  EXPECT_NEAR(seconds(8), choice.kickSeconds, 1e-3);
}

TEST_F(TimeToGoalTest, fromFarTheShortKickComesFirst) {
  situation.kicks = {kick(9)};
  // One long kick, nine metres to walk, another kick.
  EXPECT_NEAR(seconds(14), 2 * choice.kickSeconds + 9 / time.walkSpeed, 0.3);
  situation.kicks.push_back(kick(5.5));
  EXPECT_NEAR(seconds(14), 2 * choice.kickSeconds + 5.5 / time.walkSpeed, 0.3);
}

TEST_F(TimeToGoalTest, aShotThatMayMissCostsTheRestart) {
  situation.kicks = {kick(12)};
  const double sure = seconds(11);
  situation.kicks[0].scatter = 0.15;
  EXPECT_GT(seconds(11), sure + 5);
  situation.kicks[0].scatter = 1e-3;
  situation.kicks[0].rise = 3;
  EXPECT_GT(seconds(4), choice.kickSeconds + 1) << "it goes over the bar from there";
}

}  // namespace
