#include "framework/Drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "framework/DebugPoints.h"
#include "framework/DrawingSite.h"
#include "framework/TextStream.h"

namespace plumbline {
namespace {

using shapes::Annotation, shapes::Circle, shapes::Line, shapes::Point, shapes::Polygon, shapes::Sphere;

template <typename Form>
const Form& form(const Drawing& drawing, std::size_t index) {
  return std::get<Form>(drawing.shapes().at(index).form);
}

/// The robot at (1, 2), looking to the left; its torso half a metre above the ground.
struct DrawingTest : testing::Test {
  Drawing drawing;
  DrawingTest() { setDrawingFrames(Pose2(1, 2, std::numbers::pi / 2), translation(0, 0, 0.5)); }
  ~DrawingTest() override { setDrawingFrames({}, Pose3::Identity()); }
};

TEST_F(DrawingTest, placesStandInTheFramesThatWereChosen) {
  drawing.point(Vec2(3, 4), colours::red);
  drawing.in(DrawingFrame::robot);
  drawing.point(Vec2(1, 0), colours::red);
  drawing.in(DrawingFrame::torso);
  drawing.sphere(Vec3(0, 1, 0.1), 0.2, colours::red);
  drawing.in(DrawingFrame::robot, Pose2(1, 0, std::numbers::pi / 2));
  drawing.point(Vec2(1, 0), colours::red);
  EXPECT_TRUE(form<Point>(drawing, 0).position.isApprox(Vec3(3, 4, 0)));
  EXPECT_TRUE(form<Point>(drawing, 1).position.isApprox(Vec3(1, 3, 0)));
  EXPECT_TRUE(form<Sphere>(drawing, 2).centre.isApprox(Vec3(0, 2, 0.6)));
  EXPECT_TRUE(form<Point>(drawing, 3).position.isApprox(Vec3(0, 3, 0)));
}

TEST_F(DrawingTest, anArrowIsALineWithAHead) {
  drawing.arrow(Vec2(0, 0), Vec2(1, 0), colours::blue, 3);
  ASSERT_EQ(drawing.shapes().size(), 3u);
  EXPECT_EQ(form<Line>(drawing, 0).end, Vec3(1, 0, 0));
  EXPECT_EQ(form<Line>(drawing, 0).thickness, 3);
  EXPECT_TRUE(form<Line>(drawing, 1).begin.isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(form<Line>(drawing, 1).end.isApprox(Vec3(0.8, -0.1, 0)));
  EXPECT_TRUE(form<Line>(drawing, 2).end.isApprox(Vec3(0.8, 0.1, 0)));
  // Upward there is no left and right; without length there is no direction.
  drawing.arrow(Vec3(0, 0, 0), Vec3(0, 0, 1), colours::blue);
  EXPECT_TRUE(form<Line>(drawing, 5).end.allFinite());
  drawing.arrow(Vec2(1, 1), Vec2(1, 1), colours::blue);
  EXPECT_EQ(drawing.shapes().size(), 7u);
}

/// The axes of an ellipse that was drawn as lines about a centre: the longest and the shortest way from it
/// [m].
Vec2 axesOf(const Drawing& drawing, const Vec3& centre) {
  double longest = 0, shortest = 1e9;
  for (const shapes::Shape& shape : drawing.shapes()) {
    const double way = (std::get<Line>(shape.form).begin - centre).norm();
    longest = std::max(longest, way);
    shortest = std::min(shortest, way);
  }
  return {longest, shortest};
}

TEST_F(DrawingTest, anEllipseIsAClosedLineAlongTheAxesOfTheCovariance) {
  const Mat2 turn = Pose2(0, 0, 0.6).rotation();
  const Mat2 covariance = turn * Vec2(0.25, 0.01).asDiagonal() * turn.transpose();
  drawing.ellipse(Vec2(3, 4), covariance, colours::red, 2, 3);
  ASSERT_EQ(drawing.shapes().size(), 16u);
  EXPECT_TRUE(axesOf(drawing, Vec3(3, 4, 0)).isApprox(Vec2(1, 0.2), 1e-9)) << "two standard deviations";
  bool along = false;
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_TRUE(form<Line>(drawing, i).end.isApprox(form<Line>(drawing, (i + 1) % 16).begin));
    EXPECT_EQ(form<Line>(drawing, i).thickness, 3);
    along =
        along || form<Line>(drawing, i).begin.isApprox(Vec3(3 + std::cos(0.6), 4 + std::sin(0.6), 0), 1e-9);
  }
  EXPECT_TRUE(along) << "the longer axis is the covariance's";
}

TEST_F(DrawingTest, anEllipseIsTurnedWithItsFrame) {
  drawing.in(DrawingFrame::robot);  // at (1, 2), looking along y
  drawing.ellipse(Vec2(1, 0), Vec2(1, 0.01).asDiagonal().toDenseMatrix(), colours::red, 1);
  bool along = false;
  for (std::size_t i = 0; i < 16; ++i)
    along = along || form<Line>(drawing, i).begin.isApprox(Vec3(1, 4, 0), 1e-9);
  EXPECT_TRUE(along);
}

TEST_F(DrawingTest, anEllipseOfEqualAxesIsACircle) {
  drawing.ellipse(Vec2(1, 2), 0.09 * Mat2::Identity(), colours::red);
  ASSERT_EQ(drawing.shapes().size(), 1u);
  EXPECT_EQ(form<Circle>(drawing, 0).centre, Vec2(1, 2));
  EXPECT_NEAR(form<Circle>(drawing, 0).radius, 0.6, 1e-12);
}

TEST_F(DrawingTest, whatIsNoCovarianceHasNoEllipse) {
  drawing.ellipse(Vec2(0, 0), std::numeric_limits<double>::quiet_NaN() * Mat2::Identity(), colours::red);
  drawing.ellipse(Vec2(0, 0), -Mat2::Identity(), colours::red);
  drawing.ellipse(Vec2(std::numeric_limits<double>::infinity(), 0), Mat2::Identity(), colours::red);
  EXPECT_TRUE(drawing.shapes().empty());
  // A line's: one axis without length, a little below zero by rounding.
  drawing.ellipse(Vec2(0, 0), Vec2(1, -1e-18).asDiagonal().toDenseMatrix(), colours::red);
  EXPECT_EQ(drawing.shapes().size(), 16u);
  EXPECT_NEAR(axesOf(drawing, Vec3::Zero()).x(), 2, 1e-9);
}

TEST_F(DrawingTest, whatIsNotFiniteOrBeyondTheBoundsIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  drawing.circle(Vec2(nan, 0), 1, colours::red);
  drawing.circle(Vec2(0, 0), nan, colours::red);
  drawing.line(Vec2(0, 0), Vec3(0, 0, 1 / 0.0), colours::red);
  drawing.polygon({Vec2(0, 0), Vec2(1, 0), Vec2(nan, 1)}, colours::red);
  drawing.polygon({Vec2(0, 0), Vec2(1, 0)}, colours::red);
  drawing.text(Vec2(nan, 0), "lost", colours::red);
  EXPECT_TRUE(drawing.shapes().empty());
  drawing.text(Vec2(0, 0), std::string(1000, 'a'), colours::red);
  EXPECT_EQ(form<Annotation>(drawing, 0).text.size(), Drawing::maxText);
  for (std::size_t i = 0; i < Drawing::maxShapes + 5; ++i) drawing.point(Vec2(0, 0), colours::red);
  EXPECT_EQ(drawing.shapes().size(), Drawing::maxShapes);
}

TEST_F(DrawingTest, shapesAreWrittenAsThePagesTakeThem) {
  drawing.circle(Vec2(1, 2.00004), 0.5, colours::faint({255, 0, 16}, 0.5), 2);
  drawing.line(Vec2(0, 0), Vec3(1, 2, 3), {1, 2, 3}, 4);
  drawing.polygon({Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {1, 2, 3});
  drawing.text(Vec2(0, 0), "a \"b\"", {1, 2, 3});
  std::string text;
  TextOutStream out(text);
  for (const shapes::Shape& shape : drawing.shapes()) shapes::writeShape(out, shape);
  EXPECT_EQ(
      text,
      "{\"circle\" \"#ff00107f\" 1.000000 2.000000 0.500000 2.000000 } "
      "{\"line\" \"#010203\" 0.000000 0.000000 0.000000 1.000000 2.000000 3.000000 4.000000 } "
      "{\"polygon\" \"#010203\" 0.000000 0.000000 0.000000 1.000000 0.000000 0.000000 0.000000 1.000000 "
      "0.000000 } "
      "{\"text\" \"#010203\" 0.000000 0.000000 0.000000 \"a \\\"b\\\"\" }");
}

/// Counts shapes.
struct Look final : DebugRequest {
  void serve(DebugValue& value) noexcept override {
    seen = value.drawing() ? value.drawing()->shapes().size() : 0;
  }
  std::size_t seen = 0;
};

TEST(DrawingSiteTest, drawsOnceForAllAndOnlyWhenSomebodyLooks) {
  int drawn = 0;
  const auto pass = [&drawn] {
    DEBUG_DRAWING("draw:test:site", {
      ++drawn;
      drawing.point(Vec2(0, 0), colours::red);
      if (drawn > 100) return;
      drawing.point(Vec2(1, 0), colours::red);
    });
  };
  pass();
  EXPECT_EQ(drawn, 0);
  EXPECT_EQ(DebugPoints::sites().find("draw:test:site"), DebugKind::drawing);
  const auto first = std::make_shared<Look>(), second = std::make_shared<Look>();
  DebugPoints::sites().attach("draw:test:site", first);
  DebugPoints::sites().attach("draw:test:site", second);
  pass();
  EXPECT_EQ(drawn, 1);
  EXPECT_EQ(first->seen, 2u);
  EXPECT_EQ(second->seen, 2u);
  DebugPoints::sites().detach("draw:test:site", first);
  DebugPoints::sites().detach("draw:test:site", second);
  pass();
  EXPECT_EQ(drawn, 1);
}

}  // namespace
}  // namespace plumbline
