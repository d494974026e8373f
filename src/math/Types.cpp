#include "math/Types.h"

namespace plumbline {

Pose3 translation(const Vec3& t) { return Pose3(Eigen::Translation3d(t)); }
Pose3 translation(double x, double y, double z) { return translation(Vec3(x, y, z)); }

Pose3 rotation(const Vec3& axis, double angle) { return Pose3(Eigen::AngleAxisd(angle, axis)); }
Pose3 rotationX(double angle) { return rotation(Vec3::UnitX(), angle); }
Pose3 rotationY(double angle) { return rotation(Vec3::UnitY(), angle); }
Pose3 rotationZ(double angle) { return rotation(Vec3::UnitZ(), angle); }

Vec2 shortened(const Vec2& v, double most) { return v.norm() > most ? Vec2(v * (most / v.norm())) : v; }

}  // namespace plumbline
