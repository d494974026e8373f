#include "framework/Drawing.h"

#include <gtest/gtest.h>

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
