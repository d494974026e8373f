#include "gap/run/Plausibility.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gap/run/ColumnStatistics.h"

namespace plumbline::gap {
namespace {

constexpr double mostServoRatio = 50;     // times the robot's own gain or supply, or a part of it
constexpr double mostRateError = 0.05;    // of the step that the times have
constexpr double mostShift = 0.25;        // [s]: more than any bus, firmware or effect of the library delays
constexpr double mostLag = 0.5;           // [s] that a joint follows its command by, slow servos included
constexpr double mostLead = 0.02;         // [s] that it goes before it, by how clocks are read
constexpr double longestLag = 2;          // [s] to either side
constexpr double longestStep = 0.01;      // [s] between the samples that are compared
constexpr double leastCorrelation = 0.9;  // of speeds
constexpr double leastCorrelationGain = 0.2;  // of it over that at a plausible lag
constexpr double mostOwnEffort = 0.1;         // squares that are left, of those with the command before
constexpr std::size_t mostSamples = 6000;

class Plausibility {
public:
  Plausibility(const Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings)
      : run_(run), robot_(robot), warnings_(warnings), period_(medianStep(run.t)) {}

  void all() {
    const double ratio = run_.rateHz * period_;
    if (std::abs(ratio - 1) > mostRateError)
      warn("run.json", "rate_hz " + shownNumber(run_.rateHz) + " says " + shownNumber(1 / run_.rateHz) +
                           " s a line, t advances by " + shownNumber(period_) + " s; t is used");
    const auto isTruth = [](const auto& column) { return column.first.starts_with("truth."); };
    if (run_.groundTruth && std::ranges::none_of(run_.channels, isTruth))
      warn("run.json", "ground_truth is true, but there is no column truth.*");
    for (const Mechanism::Joint& joint : robot_.joints) checkServo(joint);
    for (const auto& [joint, timing] : run_.timing) checkTiming(joint, timing);
    for (const Mechanism::Joint& joint : robot_.joints) checkClocks(joint);
    for (const Mechanism::Joint& joint : withServo(robot_, run_).joints) checkEffort(joint);
  }

private:
  void warn(const std::string& channel, const std::string& why) {
    warnings_.push_back({channel, false, why});
  }

  void checkServo(const Mechanism::Joint& joint) {
    const auto found = run_.servo.find(joint.name);
    if (found == run_.servo.end()) return;
    const ServoOverride& given = found->second;
    const auto check = [&](const char* key, const std::optional<double>& x, double nominal) {
      if (!x) return;
      const std::string name = "servo." + joint.name + "." + key + " is " + shownNumber(*x);
      if (*x == 0 && nominal > 0)
        warn("run.json", name + ": the motor would do nothing; leave the key out if the value is unknown");
      else if (nominal > 0 && (*x > mostServoRatio * nominal || *x < nominal / mostServoRatio))
        warn("run.json",
             name + ", " + shownNumber(*x / nominal) + " times that of " + robot_.name + "; check its unit");
    };
    check("kp", given.kp, joint.servo.kp);
    check("max_torque", given.maxTorque, joint.maxTorque);
    check("max_speed", given.maxSpeed, joint.maxSpeed);
    check("kp_firmware", given.kpFirmware, joint.servo.kpFirmware);
    check("vin", given.vin, joint.servo.vin);
  }

  void checkTiming(const std::string& joint, const JointTiming& timing) {
    const double most = std::max(mostShift, 5 * period_);
    for (const auto& [key, field] : timingKeys)
      if (const double seconds = timing.*field; std::abs(seconds) > most)
        warn("run.json", std::string("timing.") + key + (joint == "*" ? "" : "." + joint) + " is " +
                             shownNumber(seconds) + " s, " + shownNumber(seconds / period_) +
                             " cycles; is it in s?");
  }

  /// Whether a torque is that of its own line's command, which comes into force after the line's readings.
  void checkEffort(const Mechanism::Joint& joint) {
    const auto* const cmd = run_.find(ChannelKind::command, joint.name);
    const auto* const pos = run_.find(ChannelKind::position, joint.name);
    const auto* const torque = run_.find(ChannelKind::torque, joint.name);
    const JointTiming timing = run_.timingOf(joint.name);
    if (!cmd || !pos || !torque || joint.servo.model != Servo::Model::position || timing.effortAt != 0 ||
        timing.cmdAt != 0)
      return;
    const double kp = joint.servo.kp, kd = joint.servo.kd;
    double before = 0, own = 0;
    for (std::size_t k = 1; k + 1 < run_.t.size(); ++k) {
      const double speed = ((*pos)[k + 1] - (*pos)[k - 1]) / (run_.t[k + 1] - run_.t[k - 1]);
      const double lacks = (*torque)[k] + kp * (*pos)[k] + kd * speed;
      const double a = lacks - kp * (*cmd)[k - 1], b = lacks - kp * (*cmd)[k];
      if (std::isfinite(a) && std::isfinite(b)) before += a * a, own += b * b;
    }
    if (own < mostOwnEffort * before)
      warn(
          "torque." + joint.name,
          "it is the torque of its own line's command, but commands come into force after a line's readings; "
          "add to run.json: timing: {effort_at_s: 1e-4}");
  }

  /// Whether a joint moves as commanded, but at a time that no delay explains.
  void checkClocks(const Mechanism::Joint& joint) {
    const auto* const cmd = run_.find(ChannelKind::command, joint.name);
    const auto* const pos = run_.find(ChannelKind::position, joint.name);
    if (!cmd || !pos) return;
    const auto stride =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(longestStep / period_)));
    const std::vector<double> a = speeds(*cmd, stride), b = speeds(*pos, stride);
    const double step = period_ * static_cast<double>(stride);
    const int reach = static_cast<int>(std::min(longestLag / step, static_cast<double>(a.size()) / 4));
    double best = 0, plausible = 0;
    int at = 0;
    for (int lag = -reach; lag <= reach; ++lag) {
      const double like = correlation(a, b, lag), seconds = lag * step;
      if (seconds >= -std::max(mostLead, step) - 1e-9 && seconds <= mostLag)
        plausible = std::max(plausible, like);
      if (like > best) best = like, at = lag;
    }
    if (best < leastCorrelation || best < plausible + leastCorrelationGain) return;
    warn("pos." + joint.name, "it moves as cmd." + joint.name + " does " + shownNumber(std::abs(at) * step) +
                                  (at < 0 ? " s later" : " s before") +
                                  "; are both of one clock, and in the right lines?");
  }

  static std::vector<double> speeds(const std::vector<double>& column, std::size_t stride) {
    std::vector<double> result;
    for (std::size_t i = 0; i + stride < column.size() && result.size() < mostSamples; i += stride)
      result.push_back(column[i + stride] - column[i]);
    return result;
  }

  /// Of a with b so many samples later; 0 where too little is there or moves.
  static double correlation(const std::vector<double>& a, const std::vector<double>& b, int lag) {
    double ab = 0, aa = 0, bb = 0;
    std::size_t n = 0;
    const std::size_t from = lag < 0 ? static_cast<std::size_t>(-lag) : 0;
    for (std::size_t i = from; i < a.size(); ++i) {
      const std::size_t k = lag < 0 ? i - from : i + static_cast<std::size_t>(lag);
      if (k >= b.size()) break;
      if (!std::isfinite(a[i]) || !std::isfinite(b[k])) continue;
      ab += a[i] * b[k], aa += a[i] * a[i], bb += b[k] * b[k], ++n;
    }
    return n >= 50 && aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
  }

  const Run& run_;
  const Mechanism& robot_;
  std::vector<RunWarning>& warnings_;
  const double period_;
};

}  // namespace

void checkPlausibility(const Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings) {
  Plausibility(run, robot, warnings).all();
}

}  // namespace plumbline::gap
