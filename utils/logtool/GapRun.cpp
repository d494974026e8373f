#include "GapRun.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "framework/StopSignal.h"
#include "record/Fields.h"
#include "robot/HumanoidModel.h"
#include "robot/JointStream.h"
#include "robot/MechanismFile.h"

namespace plumbline::logtool {
namespace {

using gap::ChannelKind;
using record::LogReader;

constexpr double lost = std::numeric_limits<double>::quiet_NaN();

class RunMaker {
public:
  RunMaker(LogReader& log, const LogReader::Thread& thread) : log_(log), thread_(thread) {
    for (std::size_t i = 0; i < thread.recorded.topics.size(); ++i)
      topicOf_[thread.recorded.topics[i].representation] = i;
    for (const char* name : {"FrameInfo", "RobotDescription", "JointData", "JointRequest"})
      if (!topicOf_.contains(name))
        throw std::runtime_error(log.path() + " has no " + name + ", which a run needs");
    hasBody_ = topicOf_.contains("SensorData");
  }

  gap::Run make(const record::LogPart& part, const record::Progress& progress) {
    for (std::size_t c = 0; c < thread_.cycles.size(); ++c) {
      StopSignal::throwIfCaught();
      if (progress && c % 256 == 0)
        progress(static_cast<double>(c) / static_cast<double>(thread_.cycles.size()));
      const LogReader::Cycle& cycle = thread_.cycles[c];
      read(cycle);
      const double time = record::secondsOf(cycle.timestamp);
      if (time < part.from || time > part.to || cycle.number < part.firstCycle ||
          cycle.number > part.lastCycle)
        continue;
      if (run_.robot.empty() && !begin()) continue;
      if (std::get<std::string>(value("RobotDescription.name")) != run_.robot)
        throw std::runtime_error(log_.path() + ": the robot changes from " + run_.robot + " to " +
                                 std::get<std::string>(value("RobotDescription.name")) +
                                 "; take a part with one");
      const double t = number("FrameInfo.time");
      if (!run_.t.empty() && start_ + run_.t.back() >= t) {
        if (run_.t.back() + start_ == t) continue;  // the same readings once more
        throw std::runtime_error(log_.path() + ": the platform was restarted at cycle " +
                                 std::to_string(cycle.number) + "; take a part before or behind it");
      }
      row(t);
    }
    if (run_.t.size() < 2) throw std::runtime_error(log_.path() + " has no robot's joints in that part");
    std::vector<double> steps;
    for (std::size_t i = 1; i < run_.t.size(); ++i) steps.push_back(run_.t[i] - run_.t[i - 1]);
    std::ranges::nth_element(steps, steps.begin() + static_cast<long>(steps.size() / 2));
    run_.rateHz = std::round(1e6 / steps[steps.size() / 2]) / 1e6;
    return std::move(run_);
  }

private:
  void read(const LogReader::Cycle& cycle) {
    log_.read(thread_, cycle, [&](std::size_t topic, std::string_view message) {
      const record::RecordedTopic& recorded = thread_.recorded.topics[topic];
      const std::string& name = recorded.representation;
      if (name != "FrameInfo" && name != "RobotDescription" && name != "JointData" &&
          name != "JointRequest" && name != "SensorData")
        return;
      record::visitFields(
          recorded.schema, message,
          [&](const std::string& path, const record::FieldValue& v) { values_[name + path] = v; });
    });
  }

  const record::FieldValue& value(const std::string& name) const {
    const auto found = values_.find(name);
    if (found == values_.end())
      throw std::runtime_error(log_.path() + " has no " + name + ", which a run needs");
    return found->second;
  }
  double number(const std::string& name) const { return record::fieldNumber(value(name)); }

  bool begin() {
    const auto name = std::get<std::string>(value("RobotDescription.name"));
    if (name.empty()) return false;  // not known yet
    run_.robot = name;
    run_.freeBase = true;
    start_ = number("FrameInfo.time");
    const RobotModel robot = Humanoid(findMechanism(name)).model();
    const std::vector<JointId> streamed = streamedJointsOf(robot);
    for (std::size_t i = 0; i < streamed.size(); ++i) {
      // What recorded the log may not have known of the robot's own joints.
      const std::string index = '[' + std::to_string(i) + ']';
      if (robot.has(streamed[i]) && (i < numHumanoidJoints || values_.contains("JointData.angles" + index)))
        joints_.emplace_back(robot.jointName(streamed[i]), index);
    }
    return true;
  }

  void row(double t) {
    run_.t.push_back(t - start_);
    const auto put = [&](ChannelKind kind, const std::string& place, double x) {
      run_.channels[gap::channelName(kind, place)].push_back(x);
    };
    for (const auto& [name, index] : joints_) {
      put(ChannelKind::position, name, number("JointData.angles" + index));
      double& held = held_.try_emplace(name, lost).first->second;
      if (std::get<bool>(value("JointRequest.targets.set" + index)))
        held = number("JointRequest.targets.angles" + index);
      put(ChannelKind::command, name, held);
      put(ChannelKind::stiffness, name, number("JointRequest.targets.stiffness" + index));
    }
    if (!hasBody_) return;
    for (const char* axis : {"x", "y", "z"}) {
      put(ChannelKind::gyro, axis, number(std::string("SensorData.gyro.") + axis));
      put(ChannelKind::acceleration, axis, number(std::string("SensorData.acc.") + axis));
    }
  }

  LogReader& log_;
  const LogReader::Thread& thread_;
  std::map<std::string, std::size_t> topicOf_;
  bool hasBody_ = false;
  std::map<std::string, record::FieldValue> values_;
  std::vector<std::pair<std::string, std::string>> joints_;  ///< name, and its index in a JointArray
  std::map<std::string, double> held_;  ///< the last target of a joint: what is not set stays
  gap::Run run_;
  double start_ = 0;
};

}  // namespace

gap::Run gapRun(LogReader& log, const LogReader::Thread& thread, const record::LogPart& part,
                const std::string& motion, const record::Progress& progress) {
  gap::Run run = RunMaker(log, thread).make(part, progress);
  run.motion = motion;
  return run;
}

}  // namespace plumbline::logtool
