#include "modules/behavior/formation/PlanDrawing.h"

#include <gtest/gtest.h>

#include "support/DrawnBy.h"

namespace plumbline {
namespace {

const std::vector<Vec2> threePlaces{{-1, 2}, {3, 4}, {5, -6}};

TEST(PlanDrawingTest, aSupporterHasALineToItsPlaceAndItsRoleThere) {
  Drawing drawing;
  drawRole(drawing, Vec2(1, 1), 8, PlayerRole::supporter + 1, Vec2(0, 0), threePlaces, colours::white);
  EXPECT_EQ(test::placeOf(drawing, "8 supporter 2"), Vec3(3, 4, 0));
  ASSERT_EQ(test::countOf<shapes::Line>(drawing), 1u);
  const auto& line = std::get<shapes::Line>(drawing.shapes().front().form);
  EXPECT_EQ(line.begin, Vec3(1, 1, 0));
  EXPECT_EQ(line.end, Vec3(3, 4, 0));
}

TEST(PlanDrawingTest, theStrikersPlaceIsTheBall) {
  Drawing drawing;
  drawRole(drawing, Vec2(1, 1), 7, PlayerRole::striker, Vec2(0, 9), threePlaces, colours::white);
  EXPECT_EQ(test::placeOf(drawing, "7 striker"), Vec3(0, 9, 0));
}

TEST(PlanDrawingTest, withoutAPlaceTheRoleStandsAtThePlayer) {
  Drawing drawing;
  drawRole(drawing, Vec2(-14, 0), 1, PlayerRole::goalie, Vec2(0, 0), threePlaces, colours::white);
  drawRole(drawing, Vec2(1, 1), 0, PlayerRole::none, Vec2(0, 0), threePlaces, colours::white);
  drawRole(drawing, Vec2(2, 1), 9, PlayerRole::supporter + 3, Vec2(0, 0), threePlaces, colours::white);
  EXPECT_EQ(test::placeOf(drawing, "1 goalie"), Vec3(-14, 0, 0));
  EXPECT_EQ(test::placeOf(drawing, "no role"), Vec3(1, 1, 0));
  EXPECT_EQ(test::placeOf(drawing, "9 supporter 4"), Vec3(2, 1, 0)) << "a place that the table does not have";
  EXPECT_EQ(drawing.shapes().size(), 3u);
}

TEST(PlanDrawingTest, aPlanShowsAllMembersAndNoMoreThanATeam) {
  std::vector<TeamMember> team(30);
  for (std::size_t i = 0; i < team.size(); ++i) team[i].number = static_cast<int>(i) + 1;
  Drawing drawing;
  drawPlan(drawing, team, std::vector<int>(30, PlayerRole::striker), Vec2(0, 0), threePlaces);
  EXPECT_EQ(drawing.shapes().size(), 22u) << "a line and a text each";
  Drawing few;
  drawPlan(few, team, {PlayerRole::goalie}, Vec2(0, 0), threePlaces);
  EXPECT_EQ(few.shapes().size(), 1u) << "no role, nothing to draw";
}

}  // namespace
}  // namespace plumbline
