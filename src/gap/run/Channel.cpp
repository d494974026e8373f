#include "gap/run/Channel.h"

#include <algorithm>
#include <array>

namespace plumbline::gap {
namespace {

constexpr std::array<const char*, 17> prefixes = {
    "t",       "cmd",     "cmd_vel", "cmd_torque",  "cmd_current", "stiffness", "pos", "vel",  "torque",
    "current", "voltage", "duty",    "temperature", "gyro",        "acc",       "fsr", "truth"};

bool isCorner(std::string_view corner) {
  return corner == "FrontLeft" || corner == "FrontRight" || corner == "RearLeft" || corner == "RearRight";
}

bool isAxis(std::string_view axis) { return axis == "x" || axis == "y" || axis == "z"; }

bool fits(ChannelKind kind, std::string_view place) {
  const std::size_t dot = place.find('.');
  switch (kind) {
    case ChannelKind::time:
      return place.empty();
    case ChannelKind::gyro:
    case ChannelKind::acceleration:
      return isAxis(place);
    case ChannelKind::truth:
      return isAxis(place) ||
             (place.size() == 2 && place[0] == 'q' && (place[1] == 'w' || isAxis(place.substr(1))));
    case ChannelKind::force:
      return dot != std::string_view::npos && dot > 0 && isCorner(place.substr(dot + 1));
    default:
      return !place.empty() && dot == std::string_view::npos;
  }
}

}  // namespace

const char* prefix(ChannelKind kind) { return prefixes[static_cast<std::size_t>(kind)]; }

std::string channelName(ChannelKind kind, std::string_view place) {
  return kind == ChannelKind::time ? "t" : std::string(prefix(kind)) + "." + std::string(place);
}

std::optional<ChannelName> parseChannel(std::string_view name) {
  const std::size_t dot = name.find('.');
  const std::string_view head = name.substr(0, dot);
  const auto it = std::find(prefixes.begin(), prefixes.end(), head);
  if (it == prefixes.end()) return std::nullopt;
  const auto kind = static_cast<ChannelKind>(it - prefixes.begin());
  const std::string_view place = dot == std::string_view::npos ? "" : name.substr(dot + 1);
  if ((dot != std::string_view::npos && place.empty()) || !fits(kind, place)) return std::nullopt;
  return ChannelName{kind, std::string(place)};
}

}  // namespace plumbline::gap
