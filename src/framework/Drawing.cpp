#include "framework/Drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline {
namespace {

Pose3 inSpace(const Pose2& pose) {
  return Eigen::Translation3d(pose.x(), pose.y(), 0) * Eigen::AngleAxisd(pose.heading, Vec3::UnitZ());
}

struct Frames {
  Pose3 T_field_robot = Pose3::Identity(), T_field_torso = Pose3::Identity();
};
Frames& framesOfThread() {
  thread_local Frames frames;
  return frames;
}

bool isFinite(const shapes::Form& form) {
  const auto all = [](auto... values) { return (std::isfinite(values) && ...); };
  const auto place = [](const auto& vector) { return vector.allFinite(); };
  struct Finite {
    decltype(all)& numbers;
    decltype(place)& at;
    bool operator()(const shapes::Circle& c) const { return at(c.centre) && numbers(c.radius, c.thickness); }
    bool operator()(const shapes::Line& l) const { return at(l.begin) && at(l.end) && numbers(l.thickness); }
    bool operator()(const shapes::Point& p) const { return at(p.position) && numbers(p.size); }
    bool operator()(const shapes::Sphere& s) const { return at(s.centre) && numbers(s.radius); }
    bool operator()(const shapes::Polygon& p) const { return std::ranges::all_of(p.corners, at); }
    bool operator()(const shapes::Annotation& a) const { return at(a.position); }
  };
  return std::visit(Finite{all, place}, form);
}

}  // namespace

void setDrawingFrames(const Pose2& T_field_robot, const Pose3& T_ground_torso) {
  Frames& frames = framesOfThread();
  frames.T_field_robot = inSpace(T_field_robot);
  frames.T_field_torso = frames.T_field_robot * T_ground_torso;
}

void Drawing::in(DrawingFrame frame) {
  const Frames& frames = framesOfThread();
  T_field_own_ = frame == DrawingFrame::robot   ? frames.T_field_robot
                 : frame == DrawingFrame::torso ? frames.T_field_torso
                                                : Pose3::Identity();
}

void Drawing::in(DrawingFrame frame, const Pose2& T_frame_own) {
  in(frame);
  T_field_own_ = T_field_own_ * inSpace(T_frame_own);
}

void Drawing::add(shapes::Form form, const shapes::Colour& colour) {
  if (shapes_.size() < maxShapes && isFinite(form)) shapes_.push_back({std::move(form), colour});
}

void Drawing::circle(const Place& centre, double radius, const shapes::Colour& colour, double thickness) {
  add(shapes::Circle{placed(centre).head<2>(), radius, thickness}, colour);
}

void Drawing::ellipse(const Place& centre, const Mat2& covariance, const shapes::Colour& colour,
                      double deviations, double thickness) {
  constexpr int parts = 16;
  constexpr double round = 0.95;  // share of the longer axis from which nobody sees a difference
  if (!covariance.allFinite()) return;
  // The variances along the axes of the ellipse are mean - half and mean + half; the longer axis is at
  // `turn`.
  const double mean = covariance.trace() / 2, difference = (covariance(0, 0) - covariance(1, 1)) / 2,
               common = (covariance(0, 1) + covariance(1, 0)) / 2, half = std::hypot(difference, common);
  if (mean + half < 0) return;
  // What rounding made a little negative is zero.
  const Vec2 lengths = deviations * Vec2(mean + half, std::max(0.0, mean - half)).cwiseSqrt();
  if (lengths[1] >= round * lengths[0]) return circle(centre, lengths.mean(), colour, thickness);
  const Eigen::Rotation2Dd turn(std::atan2(common, difference) / 2);
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % parts) / parts;
    Vec3 place = centre.at;
    place.head<2>() += turn * lengths.cwiseProduct(Vec2(std::cos(angle), std::sin(angle)));
    return place;
  };
  for (int i = 0; i < parts; ++i) line(at(i), at(i + 1), colour, thickness);
}

void Drawing::line(const Place& begin, const Place& end, const shapes::Colour& colour, double thickness) {
  add(shapes::Line{placed(begin), placed(end), thickness}, colour);
}

void Drawing::point(const Place& place, const shapes::Colour& colour, double size) {
  add(shapes::Point{placed(place), size}, colour);
}

void Drawing::arrow(const Place& begin, const Place& end, const shapes::Colour& colour, double thickness) {
  line(begin, end, colour, thickness);
  const Vec3 along = end.at - begin.at;
  const double length = along.norm();
  if (!(length > 1e-6)) return;
  constexpr double most = 0.2, wide = 0.5;  // the head's length [m] and half its width as part of that
  const Vec3 back = along / length * std::min(0.3 * length, most);
  // Across the arrow and as level as can be.
  Vec3 across = Vec3::UnitZ().cross(back);
  if (across.norm() < 1e-3 * back.norm()) across = Vec3::UnitX() * back.norm();
  for (const double side : {-wide, wide}) line(end, Vec3(end.at - back + side * across), colour, thickness);
}

void Drawing::pose(const Pose2& pose, double length, const shapes::Colour& colour, double thickness) {
  arrow(pose.position, Vec2(pose * Vec2(length, 0)), colour, thickness);
}

void Drawing::sphere(const Place& centre, double radius, const shapes::Colour& colour) {
  add(shapes::Sphere{placed(centre), radius}, colour);
}

void Drawing::polygon(const std::vector<Place>& corners, const shapes::Colour& colour) {
  if (corners.size() < 3 || corners.size() > maxCorners) return;
  shapes::Polygon polygon;
  for (const Place& corner : corners) polygon.corners.push_back(placed(corner));
  add(std::move(polygon), colour);
}

void Drawing::text(const Place& place, std::string_view text, const shapes::Colour& colour) {
  add(shapes::Annotation{placed(place), std::string(shapes::cutText(text, maxText))}, colour);
}

Vec3 Drawing::placed(const Place& place) const { return T_field_own_ * place.at; }

std::size_t Drawing::size() const {
  std::size_t bytes = sizeof(*this);
  for (const shapes::Shape& shape : shapes_) {
    bytes += sizeof(shape);
    if (const auto* polygon = std::get_if<shapes::Polygon>(&shape.form))
      bytes += polygon->corners.size() * sizeof(Vec3);
  }
  return bytes;
}

}  // namespace plumbline
