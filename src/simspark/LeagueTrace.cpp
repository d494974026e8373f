#include "simspark/LeagueTrace.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "framework/TextLines.h"
#include "math/Angle.h"
#include "simspark/JointNames.h"

namespace plumbline::simspark {

namespace {

constexpr std::size_t maxLineLength = 1 << 16;
constexpr std::size_t maxRows = 1'000'000;  // over five hours

void split(std::string_view text, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t comma = text.find(',');
    fields.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
  }
}

/// The columns' places, and their values in the current line.
class Columns {
public:
  Columns(TextLines& lines, std::string_view header) : lines_(lines) {
    split(header, values_);
    for (const std::string_view name : values_) indices_.emplace(name, static_cast<int>(indices_.size()));
    if (indices_.size() != values_.size()) lines_.fail("the header names a column twice");
    count_ = values_.size();
  }

  bool has(const std::string& column) const { return find(column) >= 0; }

  void read(std::string_view text) {
    split(text, values_);
    if (values_.size() != count_)
      lines_.fail("has " + std::to_string(values_.size()) + " fields, the header has " +
                  std::to_string(count_));
  }

  double number(const std::string& column) const {
    const int index = find(column);
    if (index < 0) lines_.fail("the header lacks column " + column);
    const std::string_view text = values_[static_cast<std::size_t>(index)];
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      lines_.fail("column " + column + " is no number: " + std::string(text));
    return value;
  }

  Vec3 vector(const std::string& prefix, const std::array<const char*, 3>& suffixes) const {
    return {number(prefix + suffixes[0]), number(prefix + suffixes[1]), number(prefix + suffixes[2])};
  }

private:
  int find(const std::string& column) const {
    const auto it = indices_.find(column);
    return it == indices_.end() ? -1 : it->second;
  }

  TextLines& lines_;
  std::map<std::string, int> indices_;
  std::size_t count_ = 0;
  std::vector<std::string_view> values_;
};

constexpr std::array xyz = {".x", ".y", ".z"};

/// A vector in SimSpark's body axes (right, forward, up) in this project's (forward, left, up).
Vec3 fromBodyAxes(const Vec3& v) { return {v.y(), -v.x(), v.z()}; }

Vec3 radians(const Vec3& degrees) { return degrees * (pi / 180); }

Pose3 readPose(const Columns& columns, const std::string& body) {
  Mat3 rotation;  // its columns are the directions right, forward, up
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      rotation(row, col) = columns.number(body + ".R" + std::to_string(row) + std::to_string(col));
  Mat3 house;
  house << rotation.col(1), -rotation.col(0), rotation.col(2);
  Pose3 pose = Pose3::Identity();
  pose.linear() = Eigen::Quaterniond(house).normalized().toRotationMatrix();  // the file has six digits
  pose.translation() = columns.vector(body, xyz);
  return pose;
}

std::optional<ForceReading> readForce(const Columns& columns, const std::string& sensor) {
  if (!columns.has("frp." + sensor + ".cx")) return std::nullopt;
  ForceReading force;
  force.point = fromBodyAxes(columns.vector("frp." + sensor, {".cx", ".cy", ".cz"}));
  force.force = fromBodyAxes(columns.vector("frp." + sensor, {".fx", ".fy", ".fz"}));
  if (force.point.isZero(0) && force.force.isZero(0)) return std::nullopt;
  return force;
}

TraceRow readRow(const Columns& columns, const std::vector<JointId>& joints) {
  TraceRow row;
  for (const JointId joint : joints) {
    const JointName& name = simsparkName(joint);
    const double degree = name.sign * pi / 180;
    row.command[joint] = name.sign * columns.number("cmd." + std::string(name.effector));
    row.angle[joint] = degree * columns.number("hj." + std::string(name.perceptor));
    row.axisAngle[joint] = degree * columns.number("q." + std::string(name.perceptor));
  }
  row.gyro = radians(fromBodyAxes(columns.vector("gyr", xyz)));
  row.acc = fromBodyAxes(columns.vector("acc", xyz));
  row.leftFootForce = readForce(columns, "lf");
  row.rightFootForce = readForce(columns, "rf");
  row.leftToeForce = readForce(columns, "lf1");
  row.rightToeForce = readForce(columns, "rf1");
  row.torso = readPose(columns, "torso");
  row.leftFoot = readPose(columns, "lfoot");
  row.rightFoot = readPose(columns, "rfoot");
  row.ball = columns.vector("ball", xyz);
  return row;
}

}  // namespace

TraceName traceName(const std::filesystem::path& file) {
  std::filesystem::path stem = file.filename();
  while (stem.extension() == ".gz" || stem.extension() == ".csv") stem = stem.stem();
  TraceName result{stem.string(), stem.string(), {}, {}};
  // It ends with "_t3" or "_r2t3": robot 1 to 99 and its type.
  const std::string& name = result.name;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t mark = name.rfind('_');
  if (mark == std::string::npos || name.size() < mark + 3 || name.back() < '0' || name.back() > '4' ||
      name[name.size() - 2] != 't')
    return result;
  const std::string robot = name.substr(mark + 1, name.size() - mark - 3);
  const bool numbered = (robot.size() == 2 || robot.size() == 3) && robot[0] == 'r' && robot[1] != '0' &&
                        std::all_of(robot.begin() + 1, robot.end(), digit);
  if (!robot.empty() && !numbered) return result;
  result.type = name.back() - '0';
  if (!numbered) return result;
  result.robot = std::stoi(robot.substr(1));
  result.recording = name.substr(0, mark);
  return result;
}

LeagueTrace readLeagueTrace(const std::filesystem::path& file) {
  TextLines lines(file.string(), maxLineLength, "; give a trace as .csv or .csv.gz");
  std::string_view text;
  if (!lines.next(text)) lines.fail("is empty; the first line of a trace names its columns");
  Columns columns(lines, text);

  LeagueTrace trace;
  const TraceName name = traceName(file);
  trace.name = name.name;
  trace.robotType = name.type;
  trace.robot = name.robot;
  for (int j = 0; j < numHumanoidJoints; ++j) {
    const auto joint = static_cast<JointId>(j);
    if (columns.has("cmd." + std::string(simsparkName(joint).effector))) trace.joints.push_back(joint);
  }
  while (lines.next(text)) {
    if (text.empty()) continue;
    if (trace.rows.size() == maxRows) lines.fail("is the millionth row; a trace is shorter");
    columns.read(text);
    trace.rows.push_back(readRow(columns, trace.joints));
  }
  if (trace.rows.size() < 3) lines.fail("a trace needs three rows at least");
  return trace;
}

}  // namespace plumbline::simspark
