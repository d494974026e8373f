#include "simulation/Teams.h"

#include <gtest/gtest.h>

namespace plumbline::simulation {
namespace {

TEST(Teams, firstNameIsLeftSecondIsRight) {
  Teams teams;
  EXPECT_EQ(teams.request("A", 5, 0).side, TeamSide::left);
  EXPECT_EQ(teams.request("B", 5, 0).side, TeamSide::right);
  EXPECT_EQ(teams.request("A", 6, 0).side, TeamSide::left);
  EXPECT_EQ(teams.name(TeamSide::left), "A");
  EXPECT_EQ(teams.name(TeamSide::right), "B");
  const auto third = teams.request("C", 1, 0);
  EXPECT_EQ(third.side, TeamSide::none);
  EXPECT_EQ(third.problem, "team C: two other teams play already");
}

TEST(Teams, zeroIsTheNextFreeNumber) {
  Teams teams;
  EXPECT_EQ(teams.request("A", 2, 0).unum, 2);
  EXPECT_EQ(teams.request("A", 0, 0).unum, 1);
  EXPECT_EQ(teams.request("A", 0, 0).unum, 3);
  teams.release(TeamSide::left, 1, 0);
  EXPECT_EQ(teams.request("A", 0, 0).unum, 1);
}

TEST(Teams, numbersAreTakenOnce) {
  Teams teams;
  teams.request("A", 2, 0);
  EXPECT_EQ(teams.request("A", 2, 1).problem, "team A: number 2 is taken");
  EXPECT_EQ(teams.request("A", 12, 1).problem, "team A: number 12 is not 1 to 11");
  EXPECT_EQ(teams.request("A", -1, 1).problem, "team A: number -1 is not 1 to 11");
  EXPECT_EQ(teams.request("A", 3, 5).problem, "team A: there is no robot type 5");
}

TEST(Teams, limitsOfRobotTypes) {
  Teams teams;
  for (int i = 1; i <= 7; ++i) ASSERT_EQ(teams.request("A", i, 0).problem, "");
  EXPECT_EQ(teams.request("A", 8, 0).problem, "team A: there are already 7 robots of type 0");
  EXPECT_EQ(teams.request("A", 8, 1).problem, "");
  EXPECT_EQ(teams.request("A", 9, 1).problem, "");
  EXPECT_EQ(teams.request("A", 10, 1).problem, "team A: robots of types 1 and 0 would be more than 9");
  EXPECT_EQ(teams.request("A", 10, 2).problem, "");
  EXPECT_EQ(teams.request("A", 11, 3).problem, "");
  EXPECT_EQ(teams.request("A", 0, 4).problem, "team A: there are already 11 players");
}

TEST(Teams, aFullTeamHasThreeTypes) {
  Teams teams;
  for (int i = 1; i <= 5; ++i) ASSERT_EQ(teams.request("A", i, 0).problem, "");
  for (int i = 6; i <= 9; ++i) ASSERT_EQ(teams.request("A", i, 1).problem, "");
  EXPECT_EQ(teams.request("A", 10, 0).problem, "team A: robots of types 0 and 1 would be more than 9");
  EXPECT_EQ(teams.request("A", 10, 2).problem, "");
  EXPECT_EQ(teams.request("A", 11, 2).problem, "");
}

}  // namespace
}  // namespace plumbline::simulation
