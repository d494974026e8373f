#include "field/FieldMarks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline {
namespace {

Vec3 flag(const FieldMarks& marks, std::string_view name) {
  const auto found = std::ranges::find(marks.flags, name, &FieldFlag::name);
  EXPECT_NE(found, marks.flags.end()) << name;
  return found == marks.flags.end() ? Vec3(0, 0, 0) : found->position;
}

TEST(FieldMarks, standWhereTheSizesSay) {
  FieldSize size;
  size.length = 9;
  size.width = 6;
  size.goalWidth = 1.5;
  size.goalHeight = 1.2;
  size.penaltyDepth = 1;
  size.penaltyWidth = 3;
  size.centreCircleRadius = 0.75;
  const FieldMarks marks(size);
  EXPECT_EQ(flag(marks, "G1L"), Vec3(-4.5, 0.75, 1.2));
  EXPECT_EQ(flag(marks, "G2R"), Vec3(4.5, -0.75, 1.2));
  EXPECT_EQ(flag(marks, "F2R"), Vec3(4.5, -3, 0));
  EXPECT_EQ(marks.lines[5].begin, Vec3(3.5, 1.5, 0)) << "front of the right penalty area";
  EXPECT_EQ(marks.lines[5].end, Vec3(3.5, -1.5, 0));
  for (std::size_t i = FieldMarks::numStraightLines; i < marks.lines.size(); ++i)
    EXPECT_NEAR(marks.lines[i].begin.norm(), 0.75, 1e-12);
}

/// Each half has the other's lines after half a turn.
TEST(FieldMarks, lookTheSameAfterHalfATurn) {
  const FieldMarks marks;
  for (const FieldLine& line : marks.lines) {
    const Vec3 turned = -(line.begin + line.end) / 2;
    EXPECT_TRUE(std::ranges::any_of(marks.lines, [&](const FieldLine& other) {
      return ((other.begin + other.end) / 2 - turned).norm() < 1e-12;
    }));
  }
}

}  // namespace
}  // namespace plumbline
