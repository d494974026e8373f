#include "gap/run/BodyCheck.h"

#include <cmath>
#include <string>
#include <tuple>

#include "gap/run/ColumnStatistics.h"
#include "math/Angle.h"

namespace plumbline::gap {
namespace {

class BodyChecker {
public:
  BodyChecker(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings)
      : run_(run), robot_(robot), warnings_(warnings) {}

  void checkBody() {
    const std::vector<double>*a[3], *g[3];
    const char* axes[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      a[i] = run_.find(std::string("acc.") + axes[i]);
      g[i] = run_.find(std::string("gyro.") + axes[i]);
    }
    if ((a[0] || a[1] || a[2] || g[0] || g[1] || g[2]) && !robot_.hasImu) {
      leaveOutAll("acc", robot_.name + " has no imu");
      leaveOutAll("gyro", robot_.name + " has no imu");
      return;
    }
    if (a[0] && a[1] && a[2]) {
      const double size = medianLength(*a[0], *a[1], *a[2]), g0 = robot_.gravity.norm();
      if (!(size > 0.7 * g0 && size < 1.35 * g0))
        leaveOutAll("acc", "its median length is " + shownNumber(size) + " m/s^2 instead of about " +
                               shownNumber(g0) + "; check unit, and that gravity is in");
    }
    checkGyroUnit();
    if (run_.freeBase) checkForces();
    checkTruth();
  }

private:
  void leaveOutAll(const std::string& group, const std::string& why) {
    std::vector<std::string> names;
    for (const auto& [name, column] : run_.channels)
      if (name.compare(0, group.size() + 1, group + ".") == 0) names.push_back(name);
    if (names.empty()) return;
    for (const std::string& name : names) run_.channels.erase(name);
    warnings_.push_back({group, true, why});
  }

  /// Turning seen by gravity's direction against turning seen by the gyro.
  void checkGyroUnit() {
    const std::vector<double>*ax = run_.find("acc.x"), *az = run_.find("acc.z"), *gy = run_.find("gyro.y");
    const std::vector<double>*ay = run_.find("acc.y"), *gx = run_.find("gyro.x");
    if (!ax || !az || !ay || !gx || !gy) return;
    for (const auto& [tilt, rate, name, sign] :
         {std::tuple{ax, gy, "gyro.y", -1.0}, std::tuple{ay, gx, "gyro.x", 1.0}}) {
      const Likeness like = tiltLikeness(run_.t, *tilt, *az, *rate, sign);
      if (like.pairs < 10 || like.rmsA < 0.02 || std::abs(like.correlation) < 0.7) continue;
      const double ratio = like.rmsB / like.rmsA;
      if (ratio > 0.4 * toDegrees(1) && ratio < 2.5 * toDegrees(1)) {
        leaveOutAll("gyro", "it turns " + shownNumber(ratio) + " times as fast as gravity in acc does (" +
                                name + "); is it in degrees?");
        return;
      }
    }
  }

  void checkForces() {
    std::vector<const std::vector<double>*> sensors;
    for (const auto& [name, column] : run_.channels)
      if (parseChannel(name)->kind == ChannelKind::force) sensors.push_back(&column);
    std::size_t all = 0;
    for (const Mechanism::Foot& foot : robot_.feet) all += foot.sensors.size();
    if (sensors.empty() || sensors.size() < all) return;
    const double weight = robot_.totalMass() * robot_.gravity.norm(), sum = medianSum(sensors);
    if (sum < weight / 6 || sum > 6 * weight)
      leaveOutAll("fsr", "their median sum is " + shownNumber(sum) + ", the robot weighs " +
                             shownNumber(weight) + " N; check the unit");
  }

  void checkTruth() {
    std::vector<const std::vector<double>*> q;
    for (const char* part : {"qw", "qx", "qy", "qz"})
      if (const auto* column = run_.find(std::string("truth.") + part)) q.push_back(column);
    if (q.empty()) return;
    if (q.size() < 4) {
      leaveOutAll("truth", "a quaternion has four columns");
      return;
    }
    for (std::size_t i = 0; i < run_.size(); ++i) {
      double sum = 0;
      for (const auto* column : q) sum += (*column)[i] * (*column)[i];
      if (!std::isnan(sum) && std::abs(std::sqrt(sum) - 1) > 0.02) {
        leaveOutAll("truth", "a quaternion has length " + shownNumber(std::sqrt(sum)) + " instead of 1");
        return;
      }
    }
  }

  Run& run_;
  const Mechanism& robot_;
  std::vector<RunWarning>& warnings_;
};

}  // namespace

void checkBodySensors(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings) {
  BodyChecker(run, robot, warnings).checkBody();
}

}  // namespace plumbline::gap
