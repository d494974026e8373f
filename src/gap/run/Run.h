#pragma once
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "framework/ConfigurationError.h"
#include "gap/run/Channel.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A run cannot be used; what() is one line: where, what is wrong, what to do.
class RunError : public ConfigurationError {
public:
  explicit RunError(const std::string& what);
};

/// A channel was left out of a run, or is doubtful.
struct RunWarning {
  std::string channel;   ///< column, or "run.json"
  bool leftOut = false;  ///< true: removed from Run::channels
  std::string why;
  /// One line: `FOLDER: pos.LKneePitch is left out: ...`
  std::string line(const std::string& folder) const;
};

/// Servo settings of a joint in run.json.
struct ServoOverride {
  std::optional<double> kp, kd, armature, maxTorque, maxSpeed, kpFirmware, vin;
};

/// Times relative to t [s] at which the cycle's command reached the servo, and position, speed and effort
/// (torque, current, duty) were measured.
struct JointTiming {
  double cmdAt = 0, posAt = 0, velAt = 0, effortAt = 0;
};

/// The keys of `timing` in run.json and in maps of imports.
inline constexpr std::array<std::pair<const char*, double JointTiming::*>, 4> timingKeys = {
    {{"cmd_at_s", &JointTiming::cmdAt},
     {"pos_at_s", &JointTiming::posAt},
     {"vel_at_s", &JointTiming::velAt},
     {"effort_at_s", &JointTiming::effortAt}}};

/// One recording of one motion on one robot: a table of channels by name.
struct Run {
  std::string folder;  ///< as it was given; used in messages
  std::string robot, motion, repeatOf;
  bool freeBase = false, groundTruth = false;
  double rateHz = 0;
  /// Between two cycles the commands moved linearly from one to the next, as from a controller that is faster
  /// than the log; else each was held until the next.
  bool linearCommands = false;
  std::optional<double> heading;        ///< yaw at which a free robot was put down [rad]
  std::set<std::string> unsignedKinds;  ///< channels or prefixes recorded without sign, e.g. "current"
  std::map<std::string, ServoOverride> servo;
  std::map<std::string, JointTiming> timing;  ///< "*": every joint that has no entry

  std::vector<double> t;  ///< grows strictly [s]
  /// Column by name, as long as t; NaN is a sample that was lost.
  std::map<std::string, std::vector<double>> channels;

  std::size_t size() const { return t.size(); }
  double duration() const { return t.empty() ? 0 : t.back() - t.front(); }
  /// The column, or nullptr.
  const std::vector<double>* find(const std::string& channel) const;
  const std::vector<double>* find(ChannelKind kind, const std::string& place) const {
    return find(channelName(kind, place));
  }
  JointTiming timingOf(const std::string& joint) const;
  bool isUnsigned(const std::string& channel) const;
  /// Stiffness 0..1 of a joint per cycle, 1 if it was not recorded; a lost sample counts as the last one
  /// read.
  std::vector<double> stiffnessOf(const std::string& joint) const;
  /// Joints that have a column of that kind, in the order of the names.
  std::vector<std::string> jointsWith(ChannelKind kind) const;
};

/// The robot with the run's servo settings. For a DC motor kp, kd, kpFirmware and vin are kept consistent:
/// values of run.json count, the rest follows from the law in Servo. Unknown joints are ignored.
Mechanism withServo(Mechanism robot, const Run& run);

}  // namespace plumbline::gap
