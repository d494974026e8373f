#include "modules/behavior/formation/TeamPlan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "math/Random.h"
#include "representations/behavior/PlayerRole.h"

using namespace plumbline;

namespace {

const Vec2 opponentGoal(15, 0);

struct TeamPlanTest : testing::Test {
  TeamMember memberAt(int number, double x, double y, int role = PlayerRole::none) {
    TeamMember member{number, Pose2(x, y, 0), false, role, 0};
    member.timeToBall = timeToBall(member.pose, false, ball, opponentGoal, time);
    return member;
  }
  TeamPlan plan(const std::vector<TeamMember>& members) {
    return planTeam(members, ball, FieldSize(), places, time, parameters);
  }
  Vec2 ball = {2, 0};
  std::vector<Vec2> places = {{-1, 0}, {4, 0}, {-6, 0}};
  TimeToBallParameters time;
  TeamPlanParameters parameters;
};

TEST_F(TeamPlanTest, oneStrikerOneGoalieAndEverybodyElseNearHisPlace) {
  const TeamPlan all = plan(
      {memberAt(1, -14, 0), memberAt(2, 1, 0), memberAt(3, -6, 1), memberAt(4, 4, 1), memberAt(5, -1, 1)});
  EXPECT_EQ(all.roles, (std::vector<int>{PlayerRole::goalie, PlayerRole::striker, PlayerRole::supporter + 2,
                                         PlayerRole::supporter + 1, PlayerRole::supporter}));
  EXPECT_EQ(all.strikerNumber, 2);
}

TEST_F(TeamPlanTest, aFewTakeTheFirstPlaces) {
  const TeamPlan all = plan({memberAt(2, 1, 0), memberAt(3, -6, 1)});
  EXPECT_EQ(all.roles[1], PlayerRole::supporter);
}

TEST_F(TeamPlanTest, moreThanThereArePlacesHaveNone) {
  places = {{-1, 0}};
  const TeamPlan all = plan({memberAt(2, 1, 0), memberAt(3, -6, 1), memberAt(4, -1, 1)});
  EXPECT_EQ(all.roles, (std::vector<int>{PlayerRole::striker, PlayerRole::none, PlayerRole::supporter}));
}

TEST_F(TeamPlanTest, whoeverIsAlonePlaysTheBallWhateverItsNumber) {
  EXPECT_EQ(plan({memberAt(1, -14, 0)}).roles[0], PlayerRole::striker);
}

TEST_F(TeamPlanTest, rolesStayWhereTheDifferenceIsSmall) {
  const auto strikerOf = [&](int roleOf2, int roleOf3) {
    return plan({memberAt(2, 1, 0.3, roleOf2), memberAt(3, 1, -0.5, roleOf3)}).strikerNumber;
  };
  EXPECT_EQ(strikerOf(PlayerRole::none, PlayerRole::none), 2);
  EXPECT_EQ(strikerOf(PlayerRole::supporter, PlayerRole::striker), 3);
}

TEST_F(TeamPlanTest, theGoalieComesOutOnlyForABallNearTheGoalThatItReachesFirst) {
  ball = {-12.5, 0};
  EXPECT_EQ(plan({memberAt(1, -14, 0), memberAt(2, -5, 0)}).strikerNumber, 1);
  EXPECT_EQ(plan({memberAt(1, -14, 0), memberAt(2, -13, 0)}).strikerNumber, 2);
  ball = {-9, 0};
  EXPECT_EQ(plan({memberAt(1, -14, 0), memberAt(2, 5, 0)}).strikerNumber, 2);
}

// The own penalty area begins at -13.2 m.
TEST_F(TeamPlanTest, whoGoesToABallInTheOwnAreaMayBeThere) {
  ball = {-13, 2.5};
  std::vector<TeamMember> crowd = {memberAt(1, -14.5, 0), memberAt(2, -14, 2.9), memberAt(3, -14.6, 1.5),
                                   memberAt(4, -14.7, 0.5), memberAt(5, -12.3, 2.7)};
  crowd.back().timeToBall = 1;
  const TeamPlan all = plan(crowd);
  EXPECT_EQ(all.rights, (std::vector<bool>{true, true, false, false, false}));
  EXPECT_EQ(all.strikerNumber, 2) << "numbers 3 and 4 are still there, so number 5 cannot come";
  ball = {-11, 2.5};
  EXPECT_EQ(plan({memberAt(1, -14.5, 0), memberAt(2, -14, 2.9), memberAt(3, -14.6, 1.5),
                  memberAt(4, -14.7, 0.5), memberAt(5, -11.5, 2.7)})
                .strikerNumber,
            5)
      << "a ball outside is for everybody";
}

TEST_F(TeamPlanTest, theFallenIsSlower) {
  TeamMember fallen = memberAt(2, 1, 0);
  fallen.timeToBall = timeToBall(fallen.pose, true, ball, opponentGoal, time);
  EXPECT_EQ(plan({fallen, memberAt(3, 0, 0)}).strikerNumber, 3);
}

TEST_F(TeamPlanTest, theOrderInWhichTheyWereHeardChangesNothing) {
  Random random(9);
  for (int run = 0; run < 100; ++run) {
    ball = {random.uniform(-15, 15), random.uniform(-10, 10)};
    std::vector<TeamMember> members;
    for (int number = 1; number <= 5; ++number)
      members.push_back(memberAt(number, random.uniform(-15, 15), random.uniform(-10, 10),
                                 static_cast<int>(random.next() % 6)));
    const TeamPlan before = plan(members);
    std::vector<TeamMember> turned(members.rbegin(), members.rend());
    TeamPlan after = plan(turned);
    std::ranges::reverse(after.roles);
    EXPECT_EQ(before.roles, after.roles);
    EXPECT_EQ(before.strikerNumber, after.strikerNumber);
    EXPECT_EQ(std::ranges::count(before.roles, PlayerRole::striker), 1);
    EXPECT_EQ(std::set<int>(before.roles.begin(), before.roles.end()).size(), members.size());
  }
}

TEST_F(TeamPlanTest, nobodyIsThere) { EXPECT_EQ(plan({}).strikerNumber, 0); }

TEST(TimeToBallTest, countsTheWayTheTurnTheWrongSideAndTheFall) {
  const TimeToBallParameters p;
  const Vec2 ball(0, 0);
  const double straight = timeToBall(Pose2(-2, 0, 0), false, ball, opponentGoal, p);
  EXPECT_NEAR(straight, 2 / p.walkSpeed, 1e-9);
  EXPECT_NEAR(timeToBall(Pose2(-2, 0, pi), false, ball, opponentGoal, p), straight + pi / p.turnSpeed, 1e-9);
  EXPECT_NEAR(timeToBall(Pose2(2, 0, pi), false, ball, opponentGoal, p), straight + p.wrongSide, 1e-6);
  EXPECT_NEAR(timeToBall(Pose2(-2, 0, 0), true, ball, opponentGoal, p), straight + p.getUp, 1e-9);
}

}  // namespace
