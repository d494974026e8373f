#pragma once
#include <optional>

#include "framework/Representation.h"
#include "math/Gravity.h"
#include "math/Types.h"

namespace plumbline {

/// One force sensor, in the frame of its foot or toe (origin at the body's centre).
struct FootForceData : public Streamable {
  bool contact = false;
  Vec3 point = Vec3::Zero();  ///< force-weighted point of contact [m]
  Vec3 force = Vec3::Zero();  ///< [N]

  FootForceData() = default;
  /// Of a reading with point and force; none: no contact.
  template <class Reading>
  explicit FootForceData(const std::optional<Reading>& reading) : contact(reading.has_value()) {
    if (!reading) return;
    point = reading->point;
    force = reading->force;
  }
  void stream(InStream* in, OutStream* out) override {
    STREAM(contact);
    STREAM(point);
    STREAM(force);
  }
};

/// Inertial and force readings; torso frame x forward, y left, z up.
REPRESENTATION(SensorData)
class SensorData : public SensorDataBase {
public:
  Vec3 gyro = Vec3::Zero();             ///< [rad/s]
  Vec3 acc = Vec3(0, 0, earthGravity);  ///< specific force [m/s^2]; one cycle late in SimSpark
  FootForceData leftFoot, rightFoot, leftToe, rightToe;
  bool shear = true;  ///< forces along the sole are measured as well; else only that across it
  void stream(InStream* in, OutStream* out) override {
    STREAM(gyro);
    STREAM(acc);
    STREAM(leftFoot);
    STREAM(rightFoot);
    STREAM(leftToe);
    STREAM(rightToe);
    STREAM(shear);
  }
};

}  // namespace plumbline
