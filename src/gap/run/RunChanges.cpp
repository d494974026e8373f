#include "gap/run/RunChanges.h"

#include <set>

#include "framework/ConfigurationError.h"

namespace plumbline::gap {

std::map<std::string, std::string> jointNames(const std::vector<std::string>& words) {
  std::map<std::string, std::string> names;
  std::set<std::string> taken;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == word.size())
      throw ConfigurationError("--map " + word + ": write RECORDING=ROBOT, as in l_knee=LKneePitch");
    const std::string recorded = word.substr(0, sign), robot = word.substr(sign + 1);
    if (!names.emplace(recorded, robot).second)
      throw ConfigurationError("--map " + word + ": " + recorded + " is there twice");
    if (!taken.insert(robot).second)
      throw ConfigurationError("--map " + word + ": " + robot + " is there twice");
  }
  return names;
}

namespace {

/// The same map with other names as keys.
template <class Value>
std::map<std::string, Value> renamed(std::map<std::string, Value>& old, const std::string& folder,
                                     const auto& newName) {
  std::map<std::string, Value> result;
  for (auto& [name, value] : old) {
    const std::string to = newName(name);
    if (!result.emplace(to, std::move(value)).second)
      throw RunError(folder + ": --map gives " + to + " a second time");
  }
  return result;
}

}  // namespace

void apply(const RunChanges& changes, Run& run) {
  if (changes.linearCommands) run.linearCommands = *changes.linearCommands;
  if (changes.joints.empty()) return;
  const auto jointName = [&](const std::string& joint) {
    const auto found = changes.joints.find(joint);
    return found == changes.joints.end() ? joint : found->second;
  };
  run.channels = renamed(run.channels, run.folder, [&](const std::string& name) {
    const auto channel = parseChannel(name);
    return channel && channel->ofJoint() ? channelName(channel->kind, jointName(channel->place)) : name;
  });
  run.servo = renamed(run.servo, run.folder, jointName);
  run.timing = renamed(run.timing, run.folder, jointName);
}

}  // namespace plumbline::gap
