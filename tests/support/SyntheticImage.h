#pragma once
#include <cstdint>

#include "math/Pose2.h"

#include "math/Random.h"
#include "math/Types.h"
#include "modules/modeling/selflocator/FieldView.h"
#include "simspark/ServerMessage.h"

namespace plumbline::test {

/// Images as SimSpark's vision makes them: a view of 60 degrees to each side and up and down from the head,
/// lines cut off at its border, noise, a fixed offset and rounding. Positions are on the server's field.
class SyntheticImage {
public:
  /// Everything exact.
  SyntheticImage() : random_(1), noisy_(false) {}
  /// With SimSpark's noise; the offset is drawn once.
  explicit SyntheticImage(std::uint64_t seed);

  /// All flags and goal posts, lines and the ball (drop with an optional) in view.
  simspark::See see(const Pose3& T_field_head, const Vec3& ball = Vec3(0, 0, 0.042));
  const Vec3& offset() const { return offset_; }

private:
  simspark::Polar measure(const Vec3& pointInHead);
  Random random_;
  bool noisy_;
  Vec3 offset_ = Vec3::Zero();
};

/// Head pose of a robot that stands at a place of the field with this head yaw, and the same from the robot.
Pose3 headOverGround(double headYaw = 0, double headPitch = 0, double height = 0.54);
Pose3 onField(const Pose2& place);

/// The same image as the self-localisation takes it.
FieldView fieldView(const simspark::See& see, const Pose3& T_ground_head, const VisionModel& noise = {});

}  // namespace plumbline::test
