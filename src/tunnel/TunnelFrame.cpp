#include "tunnel/TunnelFrame.h"

#include <stdexcept>

namespace plumbline::tunnel {
namespace {

constexpr char version = 1;
constexpr std::uint32_t maxStatus = 255;

void put(std::string& message, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) message += static_cast<char>(number >> shift & 0xff);
}

std::uint32_t numberAt(std::string_view message, std::size_t place) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(message[place + i]);
  return number;
}

bool isOfConnection(FrameKind kind) { return kind <= FrameKind::credit; }

/// The bounds of `value`.
std::pair<std::uint32_t, std::uint32_t> boundsOf(FrameKind kind) {
  switch (kind) {
    case FrameKind::data:
      return {1, maxFrameData};
    case FrameKind::credit:
      return {1, creditWindow};
    case FrameKind::ended:
    case FrameKind::over:
    case FrameKind::stop:
      return {0, maxStatus};
    default:
      return {0, 0};
  }
}

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument("frame: " + why); }

}  // namespace

std::string encodeFrame(const Frame& frame) {
  std::string message{'P', 'T', version, static_cast<char>(frame.kind)};
  message.reserve(frameHeader + frame.data.size());
  put(message, frame.connection);
  put(message, frame.kind == FrameKind::data ? static_cast<std::uint32_t>(frame.data.size()) : frame.value);
  return message += frame.data;
}

Frame decodeFrame(std::string_view message) {
  if (message.size() < frameHeader) refuse(std::to_string(message.size()) + " bytes are no header");
  if (message[0] != 'P' || message[1] != 'T') refuse("does not begin as one");
  if (message[2] != version)
    refuse("of version " + std::to_string(static_cast<unsigned char>(message[2])) + ", not " +
           std::to_string(version));
  const auto kind = static_cast<unsigned char>(message[3]);
  if (kind < static_cast<unsigned char>(FrameKind::open) ||
      kind > static_cast<unsigned char>(FrameKind::stop))
    refuse("of no kind that there is, " + std::to_string(kind));
  Frame frame{static_cast<FrameKind>(kind), numberAt(message, 4), numberAt(message, 8), {}};
  if (isOfConnection(frame.kind) != (frame.connection != 0))
    refuse("of kind " + std::to_string(kind) + " for connection " + std::to_string(frame.connection));
  const auto [least, most] = boundsOf(frame.kind);
  if (frame.value < least || frame.value > most)
    refuse("of kind " + std::to_string(kind) + " with " + std::to_string(frame.value) +
           ", which is not from " + std::to_string(least) + " to " + std::to_string(most));
  const std::size_t size = frame.kind == FrameKind::data ? frame.value : 0;
  if (message.size() != frameHeader + size)
    refuse(std::to_string(message.size() - frameHeader) + " bytes after the header, which says " +
           std::to_string(size));
  if (size == 0) return frame;
  frame.data = message.substr(frameHeader);
  frame.value = 0;
  return frame;
}

}  // namespace plumbline::tunnel
