#include "modules/behavior/formation/FormationTable.h"

#include <gtest/gtest.h>

#include <fstream>

#include "framework/ConfigFile.h"
#include "support/Thrown.h"

using namespace plumbline;

namespace {

FormationTable tableOf(const std::string& text) {
  const std::string path = testing::TempDir() + "formation.yaml";
  std::ofstream(path) << text;
  return FormationTable(ConfigFile(path).root());
}

constexpr const char* small = R"(ballX: [-10, 10]
ballY: [0, 8]
places:
  - name: leftBack
    x: [[-12, -4], [-12, -4]]
    y: [[2, 2], [6, 6]]
  - name: rightBack
    x: [[-12, -4], [-13, -5]]
    y: [[-2, -2], [-1, -1]]
)";

TEST(FormationTableTest, interpolatesBetweenBalls) {
  const FormationTable table = tableOf(small);
  ASSERT_EQ(table.size(), 2);
  EXPECT_EQ(table.at(0, {-10, 0}), Vec2(-12, 2));
  EXPECT_EQ(table.at(0, {0, 0}), Vec2(-8, 2));
  EXPECT_EQ(table.at(0, {0, 4}), Vec2(-8, 4));
  EXPECT_EQ(table.at(1, {10, 8}), Vec2(-5, -1));
}

TEST(FormationTableTest, mirrorsForABallOnTheRight) {
  const FormationTable table = tableOf(small);
  EXPECT_EQ(table.at(0, {10, -8}), Vec2(-5, 1));
  EXPECT_EQ(table.at(1, {0, -4}), Vec2(-8, -4));
}

TEST(FormationTableTest, staysAtItsBorders) { EXPECT_EQ(tableOf(small).at(0, {50, 90}), Vec2(-4, 6)); }

TEST(FormationTableTest, theProjectsOwnHasAPlaceForEveryPlayerOnTheField) {
  const FormationTable table(ConfigFile("config/formation.yaml").root());
  ASSERT_EQ(table.size(), 9);  // with goalie and striker eleven
  for (double x = -15; x <= 15; x += 1.5)
    for (double y = -10; y <= 10; y += 1) {
      int inOwnArea = 0;
      for (int place = 0; place < table.size(); ++place) {
        const Vec2 at = table.at(place, {x, y});
        EXPECT_LE(std::abs(at.x()), 15) << table.name(place);
        EXPECT_LE(std::abs(at.y()), 10) << table.name(place);
        inOwnArea += at.x() < -13.2 && std::abs(at.y()) < 3 ? 1 : 0;
      }
      EXPECT_LE(inOwnArea, 1) << x << " " << y;  // illegal defence: three, with goalie and striker
    }
}

TEST(FormationTableTest, itsErrorsSayWhereAndWhat) {
  const std::string path = testing::TempDir() + "formation.yaml:";
  const auto errorOf = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return thrownBy([&] { tableOf(text); });
  };
  EXPECT_EQ(errorOf(small, "[-10, 10]", "[10, -10]"), path + "1: ballX must rise from number to number");
  EXPECT_EQ(errorOf(small, "[0, 8]", "[1, 8]"),
            path + "2: ballY must begin with 0: the other side is its mirror image");
  EXPECT_EQ(
      errorOf(small, "[[2, 2], [6, 6]]", "[[2, 2]]"),
      path +
          "6: places[0].y must have a row for each of the 2 values of ballY, with a number for each of the 2 "
          "values of ballX");
  EXPECT_EQ(errorOf(small, "rightBack", "right"),
            path + "3: places must have rightBack, the mirror image of leftBack");
}

}  // namespace
