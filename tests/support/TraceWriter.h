#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "math/Angle.h"
#include "simspark/JointNames.h"
#include "simspark/LeagueTrace.h"

namespace plumbline::test {

/// One line of a recording: names of columns or their values, whichever is asked for.
class TraceLine {
public:
  explicit TraceLine(bool namesOnly) : namesOnly_(namesOnly) {}

  void add(const std::string& name, const char* format, double value) {
    char number[32];
    std::snprintf(number, sizeof number, format, value);
    text += (text.empty() ? "" : ",") + (namesOnly_ ? name : std::string(number));
  }
  void vector(const std::string& name, const std::array<const char*, 3>& ends, const char* format, Vec3 v) {
    for (int i = 0; i < 3; ++i) add(name + ends[static_cast<std::size_t>(i)], format, v[i]);
  }
  void force(const std::string& name, const std::optional<simspark::ForceReading>& reading) {
    const simspark::ForceReading r = reading.value_or(simspark::ForceReading{Vec3::Zero(), Vec3::Zero()});
    vector("frp." + name, {".cx", ".cy", ".cz"}, "%.2f", toBodyAxes(r.point));
    vector("frp." + name, {".fx", ".fy", ".fz"}, "%.2f", toBodyAxes(r.force));
  }
  void pose(const std::string& name, const Pose3& pose) {
    vector(name, {".x", ".y", ".z"}, "%.6g", pose.translation());
    Mat3 rotation;  // columns right, forward, up
    rotation << -pose.linear().col(1), pose.linear().col(0), pose.linear().col(2);
    for (int row = 0; row < 3; ++row)
      for (int col = 0; col < 3; ++col)
        add(name + ".R" + std::to_string(row) + std::to_string(col), "%.6g", rotation(row, col));
  }

  static Vec3 toBodyAxes(const Vec3& v) { return {-v.y(), v.x(), v.z()}; }

  std::string text;

private:
  bool namesOnly_;
};

inline std::string traceLine(const simspark::TraceRow& row, const std::vector<JointId>& joints,
                             bool namesOnly) {
  TraceLine line(namesOnly);
  for (const JointId joint : joints) {
    const simspark::JointName& name = simspark::simsparkName(joint);
    line.add("cmd." + std::string(name.effector), "%.17g", name.sign * row.command[joint]);
    line.add("hj." + std::string(name.perceptor), "%.2f", name.sign * toDegrees(row.angle[joint]));
    line.add("q." + std::string(name.perceptor), "%.4f", name.sign * toDegrees(row.axisAngle[joint]));
  }
  line.vector("gyr", {".x", ".y", ".z"}, "%.2f", TraceLine::toBodyAxes(row.gyro) * (180 / pi));
  line.vector("acc", {".x", ".y", ".z"}, "%.2f", TraceLine::toBodyAxes(row.acc));
  line.force("lf", row.leftFootForce);
  line.force("rf", row.rightFootForce);
  line.pose("torso", row.torso);
  line.pose("rfoot", row.rightFoot);
  line.pose("lfoot", row.leftFoot);
  line.vector("ball", {".x", ".y", ".z"}, "%.6g", row.ball);
  return line.text;
}

/// Writes rows in the form of a recording of the league's server, as plain CSV: its axes, signs, units and
/// rounding. Message values have two decimals, angles about the axes four, poses six digits in all.
inline void writeTrace(const std::filesystem::path& file, const std::vector<JointId>& joints,
                       const std::vector<simspark::TraceRow>& rows) {
  std::ofstream out(file);
  out << traceLine(rows.at(0), joints, true) << '\n';
  for (const simspark::TraceRow& row : rows) out << traceLine(row, joints, false) << '\n';
}

}  // namespace plumbline::test
