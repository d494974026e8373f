#include "modules/modeling/ground/SupportOdometry.h"

#include <cmath>

namespace plumbline {
namespace {
double headingOf(const Mat3& r) { return std::atan2(r(1, 0), r(0, 0)); }
}  // namespace

void SupportOdometry::reset() {
  started_ = false;
  airborneFor_ = 0;
  speed_.setZero();
}

Pose2 SupportOdometry::update(const Mat3& R_world_torso, std::span<const Pose3> T_torso_link,
                              std::span<const Contact> contacts, double dt) {
  Pose2 step;
  if (started_ && linksBefore_.size() == T_torso_link.size() && dt > 0) {
    Vec3 weighted = Vec3::Zero();
    double load = 0;
    for (const Contact& contact : contacts) {
      const auto link = static_cast<std::size_t>(contact.link);
      if (!(contact.load > 0) || link >= T_torso_link.size()) continue;
      const Vec3 before = R_before_ * (linksBefore_[link] * contact.point);
      const Vec3 now = R_world_torso * (T_torso_link[link] * contact.point);
      weighted += contact.load * (before - now);
      load += contact.load;
    }
    airborneFor_ = load > 0 ? 0 : airborneFor_ + dt;
    if (load > 0)
      speed_ = (weighted / (load * dt)).head<2>();
    else if (airborneFor_ > airborneSeconds_)
      speed_.setZero();
    const double heading = headingOf(R_before_);
    step = Pose2(Vec2(Eigen::Rotation2Dd(-heading) * (speed_ * dt)),
                 normalizeAngle(headingOf(R_world_torso) - heading));
  }
  started_ = true;
  R_before_ = R_world_torso;
  linksBefore_.assign(T_torso_link.begin(), T_torso_link.end());
  return step;
}

}  // namespace plumbline
