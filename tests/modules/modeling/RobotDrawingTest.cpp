#include "modules/modeling/others/RobotDrawing.h"

#include <gtest/gtest.h>

#include "support/DrawnBy.h"

namespace plumbline {
namespace {

TEST(RobotDrawingTest, showsWhereARobotIsHowSureThatIsAndWhoItIs) {
  OtherRobot mate, opponent;
  mate.mate = true;
  mate.number = 5;
  mate.position = {1, 2};
  mate.covariance = Vec2(0.04, 0.01).asDiagonal();
  opponent.position = {-3, 0};
  opponent.covariance = 0.25 * Mat2::Identity();
  opponent.fallen = true;
  Drawing drawing;
  drawRobots(drawing, {mate, opponent}, beliefColours::sight);
  EXPECT_EQ(test::placeOf(drawing, "mate 5"), Vec3(1, 2, 0));
  EXPECT_EQ(test::placeOf(drawing, "opp ?"), Vec3(-3, 0, 0));
  EXPECT_EQ(test::countOf<shapes::Line>(drawing), 16u + 2u) << "an ellipse, and the cross of who lies";
  EXPECT_EQ(test::countOf<shapes::Circle>(drawing), 1u) << "equally sure in all directions";
  for (const shapes::Shape& shape : drawing.shapes())
    if (const auto* circle = std::get_if<shapes::Circle>(&shape.form)) {
      EXPECT_DOUBLE_EQ(circle->radius, 1) << "two standard deviations";
      EXPECT_EQ(shape.colour, beliefColours::sight);
    }
}

TEST(RobotDrawingTest, theNumberOfShapesIsBounded) {
  Drawing drawing;
  std::vector<OtherRobot> robots(1000);
  for (OtherRobot& robot : robots) {
    robot.covariance = Vec2(1, 0.1).asDiagonal();
    robot.fallen = true;
  }
  drawRobots(drawing, robots, beliefColours::heard);
  EXPECT_EQ(drawing.shapes().size(), 22u * 20u);
}

TEST(RobotDrawingTest, theThreeBeliefsHaveDifferentColours) {
  EXPECT_FALSE(beliefColours::sight == beliefColours::heard);
  EXPECT_FALSE(beliefColours::sight == beliefColours::combined);
  EXPECT_FALSE(beliefColours::heard == beliefColours::combined);
}

}  // namespace
}  // namespace plumbline
