#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::gap {

/// Kind of a column of a run, see doc/reference/gap-run-format.md.
enum class ChannelKind {
  time,
  command,
  commandSpeed,
  commandTorque,
  commandCurrent,
  stiffness,
  position,
  velocity,
  torque,
  current,
  voltage,
  duty,
  temperature,
  gyro,
  acceleration,
  force,
  truth
};

struct ChannelName {
  ChannelKind kind = ChannelKind::time;
  std::string place;  ///< the joint; x, y, z; FOOT.CORNER; empty for the time

  bool ofJoint() const { return kind >= ChannelKind::command && kind <= ChannelKind::temperature; }
};

/// Splits `pos.LKneePitch`; nothing for a name that the format does not have.
std::optional<ChannelName> parseChannel(std::string_view name);
/// The prefix of a kind: `cmd`, `pos`, ..., `t` for the time.
const char* prefix(ChannelKind kind);
/// `pos.LKneePitch`
std::string channelName(ChannelKind kind, std::string_view place);

}  // namespace plumbline::gap
