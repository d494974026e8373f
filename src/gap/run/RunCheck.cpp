#include "gap/run/RunCheck.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "gap/run/BodyCheck.h"
#include "gap/run/ColumnStatistics.h"
#include "gap/run/CommandCheck.h"
#include "gap/run/Plausibility.h"
#include "gap/run/RunFile.h"
#include "math/Angle.h"

namespace plumbline::gap {
namespace {

constexpr double leastRms = 0.02;    ///< of a joint that moves [rad]
constexpr double mostBeyond = 0.35;  ///< the limits [rad]; encoders and stops may be as bad as that

constexpr double leastCommand = 0.05;  ///< command from which on degrees would be far from it [rad]
constexpr double mostSpeedRatio = 3;   ///< a joint that falls reaches so many times its motor's speed
constexpr std::size_t leastPairs = 50;
constexpr double encoderJump = 0.05;  ///< rad between two samples

struct Bounds {
  ChannelKind kind;
  double low, high;
};
// What no sensor of a robot on legs or a bench gives in these units.
constexpr Bounds bounds[] = {
    {ChannelKind::stiffness, 0, 1},           {ChannelKind::velocity, -60, 60},
    {ChannelKind::torque, -500, 500},         {ChannelKind::current, -200, 200},
    {ChannelKind::voltage, -100, 100},        {ChannelKind::duty, -1.001, 1.001},
    {ChannelKind::temperature, -30, 150},     {ChannelKind::gyro, -60, 60},
    {ChannelKind::acceleration, -400, 400},   {ChannelKind::force, -10, 1000},
    {ChannelKind::commandSpeed, -60, 60},     {ChannelKind::commandTorque, -500, 500},
    {ChannelKind::commandCurrent, -200, 200},
};

/// The foot of a force sensor's place: LFoot of LFoot.FrontLeft.
std::string footOf(const std::string& place) { return {place.begin(), std::ranges::find(place, '.')}; }

class Checker {
public:
  Checker(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings)
      : run_(run), robot_(robot), warnings_(warnings), period_(medianStep(run_.t)) {}

  void all() {
    checkTime();
    checkNames();
    checkBounds();
    checkJoints();
    checkCommands(run_, robot_);
    checkPlausibility(run_, robot_, warnings_);
    checkBodySensors(run_, robot_, warnings_);
    checkWhatIsLeft();
  }

private:
  [[noreturn]] void refuse(const std::string& why) const { throw RunError(run_.folder + ": " + why); }
  void warn(const std::string& channel, const std::string& why) {
    warnings_.push_back({channel, false, why});
  }
  void leaveOut(const std::string& channel, const std::string& why) {
    if (run_.channels.erase(channel)) warnings_.push_back({channel, true, why});
  }

  void checkTime() {
    const double ratio = run_.rateHz * period_;
    if (ratio < 0.8 || ratio > 1.25)
      refuse("t advances " + shownNumber(period_) + " s a line, but rate_hz " + shownNumber(run_.rateHz) +
             " says " + shownNumber(1 / run_.rateHz) + " s" +
             (std::abs(std::log10(ratio) - 3) < 0.1 ? "; is t in ms?" : "; correct one of them"));
    if (run_.t[0] < -1e-9 || run_.t[0] > std::max(1.0, 20 * period_))
      warn("t", "starts at " + shownNumber(run_.t[0]) + " s instead of 0; only differences are used");
    double inGaps = 0;
    for (std::size_t i = 1; i < run_.size(); ++i)
      if (run_.t[i] - run_.t[i - 1] > 1.8 * period_) inGaps += run_.t[i] - run_.t[i - 1];
    if (inGaps > 0.2 * run_.duration())
      warn("t", shownNumber(100 * inGaps / run_.duration()) + " % of the time is in gaps");
    if (run_.duration() < 1)
      warn("t", "the run is only " + shownNumber(run_.duration()) + " s long; little can be learnt from it");
  }

  void checkNames() {
    if (run_.robot != robot_.name)
      warn("run.json", "the run names robot " + run_.robot + ", the model is " + robot_.name);
    std::vector<std::string> columns;
    std::size_t ofJoints = 0, unknown = 0;
    std::string first;
    for (const auto& [name, column] : run_.channels) {
      const auto channel = parseChannel(name);
      if (!channel) continue;
      const bool known = channel->ofJoint()                    ? robot_.jointIndex(channel->place) >= 0
                         : channel->kind == ChannelKind::force ? robot_.footIndex(footOf(channel->place)) >= 0
                                                               : true;
      if (channel->ofJoint()) ++ofJoints;
      if (known) continue;
      if (channel->ofJoint()) {
        ++unknown;
        if (first.empty()) first = channel->place;
      }
      columns.push_back(name);
    }
    if (2 * unknown > ofJoints)
      refuse("this is a run of another robot: " + robot_.name + " has no joint " + first +
             ", nor most of the others");
    for (const std::string& name : columns) {
      const ChannelName channel = *parseChannel(name);
      leaveOut(name, robot_.name + (channel.ofJoint() ? " has no joint " + channel.place
                                                      : " has no foot " + footOf(channel.place)));
    }
    for (const auto& [joint, servo] : run_.servo)
      if (robot_.jointIndex(joint) < 0)
        warn("run.json", "servo." + joint + ": " + robot_.name + " has no such joint");
    for (const auto& [joint, timing] : run_.timing)
      if (joint != "*" && robot_.jointIndex(joint) < 0)
        warn("run.json", "timing names " + joint + ", which is no joint of " + robot_.name);
  }

  bool slides(const std::string& joint) const {
    return robot_.joints[static_cast<std::size_t>(robot_.jointIndex(joint))].type ==
           Mechanism::Joint::Type::prismatic;
  }

  void checkBounds() {
    std::vector<std::pair<std::string, std::string>> wrong;
    for (const auto& [name, column] : run_.channels) {
      const ChannelName channel = *parseChannel(name);
      const auto it = std::find_if(std::begin(bounds), std::end(bounds),
                                   [&](const Bounds& b) { return b.kind == channel.kind; });
      const double share = lostShare(column);
      if (share > 0.5) warn(name, shownNumber(100 * share) + " % of the samples are lost");
      if (it == std::end(bounds) || (channel.ofJoint() && slides(channel.place))) continue;
      const Extremes e = extremesOf(column);
      if (e.low < it->low || e.high > it->high)
        wrong.emplace_back(name, "it reaches " + shownNumber(e.low < it->low ? e.low : e.high) +
                                     ", outside " + shownNumber(it->low) + " to " + shownNumber(it->high) +
                                     "; check its unit");
    }
    for (const auto& [name, why] : wrong) leaveOut(name, why);
  }

  // ---- joints ----
  struct Motion {
    const std::vector<double>* cmd = nullptr;
    const std::vector<double>* pos = nullptr;
    std::vector<bool> on;  ///< the motor is on and was so for a second
  };

  Motion motionOf(const std::string& joint) const {
    Motion m{run_.find(ChannelKind::command, joint), run_.find(ChannelKind::position, joint), {}};
    const std::vector<double> stiffness = run_.stiffnessOf(joint);
    m.on.resize(run_.size());
    double since = run_.t[0] - 1;
    for (std::size_t i = 0; i < run_.size(); ++i) {
      if (stiffness[i] <= 0) since = run_.t[i];
      m.on[i] = stiffness[i] > 0 && run_.t[i] - since >= 1;
    }
    return m;
  }

  void checkJoints() {
    int inDegrees = 0, checked = 0;
    std::vector<std::pair<std::string, std::string>> wrong;

    bool anyCommandMoves = false;
    for (const Mechanism::Joint& joint : robot_.joints) {
      for (const ChannelKind kind : {ChannelKind::command, ChannelKind::position}) {
        const std::string name = channelName(kind, joint.name);
        const std::vector<double>* column = run_.find(name);
        if (!column) continue;
        ++checked;
        const Extremes e = extremesOf(*column);
        const double over = std::max(e.high - joint.upper, joint.lower - e.low);
        const bool isSlider = joint.type == Mechanism::Joint::Type::prismatic;
        if (over <= (isSlider ? 0.1 : mostBeyond)) {
          if (over > 0.05)
            warn(name,
                 "it goes " + shownNumber(over) + (isSlider ? " m" : " rad") + " beyond the joint's limits");
          continue;
        }
        if (kind == ChannelKind::position && leavesItsCommand(joint)) {
          warn(name, "it goes " + shownNumber(over) +
                         " rad beyond the joint's limits, but its command never is; kept, because the joint "
                         "follows its command most of the time and is no faster than when it falls");
          continue;
        }
        const double most = std::max(std::abs(e.low), std::abs(e.high));
        const bool degrees =
            !isSlider &&
            most / toDegrees(1) <= std::max(std::abs(joint.lower), std::abs(joint.upper)) + mostBeyond;
        inDegrees += degrees && most > 5;
        wrong.emplace_back(name, "it reaches " + shownNumber(over == e.high - joint.upper ? e.high : e.low) +
                                     ", limits are " + shownNumber(joint.lower) + " to " +
                                     shownNumber(joint.upper) +
                                     (isSlider  ? " m"
                                      : degrees ? " rad; are these degrees?"
                                                : " rad"));
      }
    }
    if (checked > 2 && 2 * inDegrees > checked)
      refuse("commands and positions are far outside the joints' limits (" + wrong[0].first + ": " +
             wrong[0].second + "); convert to rad");
    for (const auto& [name, why] : wrong) leaveOut(name, why);

    for (const Mechanism::Joint& joint : robot_.joints)
      if (run_.find(ChannelKind::command, joint.name)) anyCommandMoves |= checkFollowing(joint);
    const Mechanism driven = withServo(robot_, run_);
    for (const Mechanism::Joint& joint : driven.joints) {
      leaveOutUselessCommands(run_, joint, warnings_);
      checkSpeed(joint);
      if (joint.driver >= 0) continue;  // its driver's command is its own
      const bool hasCommand =
                     run_.find(ChannelKind::command, joint.name) || wasSentSpeedOrTorque(run_, joint.name),
                 hasPosition = run_.find(ChannelKind::position, joint.name);
      if (!hasCommand && !hasPosition)
        warn("run.csv", "has neither cmd." + joint.name + " nor pos." + joint.name + "; it is held still");
      else if (!hasCommand)
        warn("pos." + joint.name, "there is no cmd." + joint.name + "; the joint is moved as it was seen");
      else if (!hasPosition)
        warn("cmd." + joint.name, "there is no pos." + joint.name + " to hold against it");
    }
    anyCommandMoves = anyCommandMoves || std::ranges::any_of(robot_.joints, [&](const auto& j) {
                        return wasSentSpeedOrTorque(run_, j.name);
                      });
    if (!anyCommandMoves && !run_.jointsWith(ChannelKind::command).empty())
      warn("run.csv", "no command changes; a robot that does not move shows little");
  }

  /// Whether a hinge's position is beyond its limits because the joint went there: it follows its command,
  /// which is not, most of the time, and never jumps.
  bool leavesItsCommand(const Mechanism::Joint& joint) const {
    const std::vector<double>*pos = run_.find(ChannelKind::position, joint.name),
          *cmd = run_.find(ChannelKind::command, joint.name);
    if (!cmd || joint.type == Mechanism::Joint::Type::prismatic) return false;
    const Extremes command = extremesOf(*cmd);
    if (command.low < joint.lower - mostBeyond || command.high > joint.upper + mostBeyond) return false;
    const Following like = followingOf(*cmd, *pos, leastCommand);
    return like.pairs > leastPairs && 2 * like.distance < like.size &&
           fastest(run_.t, *pos, encoderJump) < mostSpeedRatio * joint.maxSpeed;
  }

  /// Largest distance of the position from a constant command while the motor is on, a hundredth left out.
  static double largestOffset(const Motion& m, double command) {
    std::vector<double> offsets;
    for (std::size_t i = 0; i < m.on.size(); ++i)
      if (m.on[i] && !std::isnan((*m.pos)[i])) offsets.push_back(std::abs((*m.pos)[i] - command));
    if (offsets.size() < 20) return 0;
    const auto at = offsets.end() - 1 - static_cast<std::ptrdiff_t>(offsets.size() / 100);
    std::nth_element(offsets.begin(), at, offsets.end());
    return *at;
  }

  /// How far a load can push a joint from its command: twice the motor's limit. On a robot with a fixed base
  /// joints carry only what hangs on them. There it is four times the moment of the largest weight (half the
  /// gain, and as much again from motion) and the backlash of a gear.
  double allowedOffset(const Mechanism::Joint& joint) const {
    const bool slider = joint.type == Mechanism::Joint::Type::prismatic;
    const double limit = std::max(slider ? 0.015 : 0.15, 2 * joint.maxTorque / joint.servo.kp);
    if (run_.freeBase) return limit;
    return std::min(limit, (slider ? 0.005 : 0.05) + 4 * largestMoment(joint) / joint.servo.kp);
  }

  /// Moment about the joint of all it carries, stretched out level (a slider: its weight).
  double largestMoment(const Mechanism::Joint& joint) const {
    std::vector<double> reach(robot_.links.size(), -1);
    reach[static_cast<std::size_t>(joint.child)] = 0;
    double moment = 0;
    for (auto l = static_cast<std::size_t>(joint.child); l < robot_.links.size(); ++l) {
      if (reach[l] < 0) {
        const double before = reach[static_cast<std::size_t>(robot_.links[l].parent)];
        if (before < 0) continue;
        reach[l] = before + robot_.joints[l - 1].origin.norm();
      }
      const bool slider = joint.type == Mechanism::Joint::Type::prismatic;
      moment += robot_.links[l].mass * (slider ? 1 : reach[l] + robot_.links[l].com.norm());
    }
    return moment * robot_.gravity.norm();
  }

  /// A command that its joint follows a thousand times as far.
  static bool isThousandth(const Likeness& like, double unit) {
    return like.rmsB > leastRms * unit && like.correlation > 0.6 &&
           std::abs(like.rmsB / like.rmsA / 1000 - 1) < 0.3;
  }

  /// True if the command moves.
  bool checkFollowing(const Mechanism::Joint& joint) {
    const std::string cmdName = "cmd." + joint.name, posName = "pos." + joint.name;
    const Motion m = motionOf(joint.name);
    const Extremes command = extremesOf(*m.cmd);
    const bool commandMoves = command.high > command.low;
    if (!m.pos) return commandMoves;
    const bool slider = joint.type == Mechanism::Joint::Type::prismatic;
    const double unit = slider ? 0.1 : 1;  // a slider's metre against a joint's radian
    const Likeness like = likenessOf(*m.cmd, *m.pos, m.on);
    const Extremes position = extremesOf(*m.pos);
    if (!commandMoves) {
      const double off = largestOffset(m, command.low), most = allowedOffset(joint);
      if (off > most)
        leaveOut(cmdName, "it is constant while " + posName + " is up to " + shownNumber(off) +
                              " away from it, more than a load explains; the command was not recorded");
      return false;
    }
    if (like.pairs >= 20 && isThousandth(like, unit)) {
      leaveOut(cmdName, posName + " moves " + shownNumber(like.rmsB / like.rmsA) +
                            " times as far; was it divided by a thousand?");
      return true;
    }
    if (like.pairs < 20 || like.rmsA < leastRms * unit) return true;
    if (position.low == position.high) {
      leaveOut(posName, "it never changes while " + cmdName + " moves by " +
                            shownNumber(command.high - command.low) + "; the sensor is stuck");
    } else if (like.correlation < -0.8) {
      leaveOut(posName, "it moves against " + cmdName + "; is its sign turned round?");
    } else if (!slider && like.correlation > 0.6 &&
               std::abs(like.rmsB / like.rmsA * toDegrees(1) - 1) < 0.3) {
      leaveOut(cmdName, "it moves " + shownNumber(like.rmsA / like.rmsB) + " times as far as " + posName +
                            "; is it in degrees?");
    } else if (!slider && like.correlation > 0.6 &&
               std::abs(like.rmsB / like.rmsA / toDegrees(1) - 1) < 0.3) {
      leaveOut(posName, "it moves " + shownNumber(like.rmsB / like.rmsA) + " times as far as " + cmdName +
                            "; is it in degrees?");
    } else if (like.rmsB > 5 * like.rmsA) {
      warn(posName, "it moves " + shownNumber(like.rmsB / like.rmsA) + " times as far as " + cmdName +
                        "; check its unit");
    } else if (like.rmsB < 0.02 * like.rmsA) {
      warn(posName, "it does not follow " + cmdName + "; a stuck joint, or another one's sensor");
    }
    return true;
  }

  void checkSpeed(const Mechanism::Joint& joint) {
    const std::string name = "vel." + joint.name;
    const std::vector<double>* velocity = run_.find(name);
    const std::vector<double>* position = run_.find(ChannelKind::position, joint.name);
    if (!velocity || !position) return;
    const SpeedLikeness like = speedLikeness(run_.t, *position, *velocity, period_);
    if (like.rms < 0.1) return;
    if (std::abs(like.correlation) > 0.6 && (like.slope < 0.6 || like.slope > 1.6)) {
      const bool degrees = std::abs(like.slope / toDegrees(1) - 1) < 0.3;
      leaveOut(name, "it is " + shownNumber(like.slope) + " times the speed of pos." + joint.name +
                         (degrees          ? "; is it in degrees?"
                          : like.slope < 0 ? "; is its sign turned round?"
                                           : "; check its unit"));
    } else if (std::abs(like.correlation) < 0.4 && extremesOf(*velocity).low >= 0 && !run_.isUnsigned(name)) {
      leaveOut(name, "it has no sign; add to run.json: unsigned: [\"vel\"]");
    } else if (std::abs(like.correlation) < 0.4) {
      warn(name, "it has little to do with pos." + joint.name + " (correlation " +
                     shownNumber(like.correlation) + ")");
    }
  }

  void checkWhatIsLeft() {
    if (run_.jointsWith(ChannelKind::command).empty() &&
        std::ranges::none_of(robot_.joints,
                             [&](const auto& j) { return wasSentSpeedOrTorque(run_, j.name); }))
      refuse("no usable cmd column" + reasons());
    if (run_.jointsWith(ChannelKind::position).empty()) refuse("no usable pos column" + reasons());
  }

  std::string reasons() const {
    for (const RunWarning& warning : warnings_)
      if (warning.leftOut) return " is left (" + warning.channel + ": " + warning.why + ")";
    return "; a run needs commands and positions";
  }

  Run& run_;
  const Mechanism& robot_;
  std::vector<RunWarning>& warnings_;
  const double period_;
};

}  // namespace

void checkRun(Run& run, const Mechanism& robot, std::vector<RunWarning>& warnings) {
  Checker(run, robot, warnings).all();
}

Run readCheckedRun(const std::string& folder, const Mechanism& robot, std::vector<RunWarning>& warnings,
                   const RunChanges& changes) {
  Run run = readRun(folder, warnings);
  apply(changes, run);
  checkRun(run, robot, warnings);
  return run;
}

}  // namespace plumbline::gap
