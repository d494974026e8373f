#pragma once
#include <string>
#include <vector>

#include "framework/Shapes.h"
#include "math/Pose2.h"

namespace plumbline {

/// The frames that a drawing's places may be given in. field: the team's frame, as RobotPose. robot: on the
/// ground below the torso, x its heading. torso: the torso's own.
enum class DrawingFrame : std::uint8_t { field, robot, torso };

/// Where robot and torso are, of the thread that calls; the module DrawingFrames says so in each cycle.
void setDrawingFrames(const Pose2& T_field_robot, const Pose3& T_ground_torso);

/// Colours that differ clearly on grass.
namespace colours {
inline constexpr shapes::Colour white{255, 255, 255}, black{20, 20, 20}, red{235, 64, 52},
    orange{255, 150, 30}, yellow{255, 225, 60}, green{60, 220, 110}, cyan{70, 215, 230}, blue{80, 140, 255},
    violet{190, 120, 255};
/// The same colour, seen through; alpha 0 .. 1.
constexpr shapes::Colour faint(shapes::Colour colour, double alpha) {
  colour.alpha = static_cast<std::uint8_t>(255 * alpha);
  return colour;
}
}  // namespace colours

/// Shapes for the eye. Whatever is drawn is turned into the field's frame at once. A shape with a number that
/// is not finite is left out, and so is what goes beyond the bounds.
class Drawing {
public:
  static constexpr std::size_t maxShapes = 4000, maxCorners = 64, maxText = 200;

  /// A place in the drawing's frame; of two numbers: on the ground.
  struct Place {
    template <typename Derived>
    Place(const Eigen::MatrixBase<Derived>& v) : at(v[0], v[1], 0) {  // NOLINT: meant to be implicit
      static_assert(Derived::SizeAtCompileTime == 2 || Derived::SizeAtCompileTime == 3);
      if constexpr (Derived::SizeAtCompileTime == 3) at.z() = v[2];
    }
    Vec3 at;
  };

  /// The frame of all places that follow.
  void in(DrawingFrame frame);
  /// All places that follow are in a frame of their own, which lies there in `frame`.
  void in(DrawingFrame frame, const Pose2& T_frame_own);

  void circle(const Place& centre, double radius, const shapes::Colour& colour, double thickness = 2);
  /// Where a point lies that is normally distributed about `centre`, out to so many standard deviations. The
  /// covariance [m^2] is that of x and y in the drawing's frame. A circle where all directions are about as
  /// uncertain, else a line of 16 parts; nothing for what is no covariance.
  void ellipse(const Place& centre, const Mat2& covariance, const shapes::Colour& colour,
               double deviations = 2, double thickness = 2);
  void line(const Place& begin, const Place& end, const shapes::Colour& colour, double thickness = 2);
  void point(const Place& place, const shapes::Colour& colour, double size = 4);
  void arrow(const Place& begin, const Place& end, const shapes::Colour& colour, double thickness = 2);
  /// An arrow of that length where the pose looks to.
  void pose(const Pose2& pose, double length, const shapes::Colour& colour, double thickness = 2);
  void sphere(const Place& centre, double radius, const shapes::Colour& colour);
  /// Convex, filled.
  void polygon(const std::vector<Place>& corners, const shapes::Colour& colour);
  void text(const Place& place, std::string_view text, const shapes::Colour& colour);

  const std::vector<shapes::Shape>& shapes() const { return shapes_; }
  /// Bytes, about.
  std::size_t size() const;

private:
  Vec3 placed(const Place& place) const;
  void add(shapes::Form form, const shapes::Colour& colour);

  Pose3 T_field_own_ = Pose3::Identity();
  std::vector<shapes::Shape> shapes_;
};

}  // namespace plumbline
