#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace plumbline::tunnel {

/// What a message between two ranks says. Of a connection: open to end or reset. Of the rank itself: the
/// rest.
enum class FrameKind : std::uint8_t {
  open = 1,  ///< somebody connected to the port at this end
  data,      ///< bytes of it
  end,       ///< no more bytes this way; those of the other way go on
  reset,     ///< the connection broke: nothing more in either way
  credit,    ///< so many bytes were passed on, so many more may come
  alive,     ///< nothing, now and then: silence means that a rank has gone
  ended,     ///< the worker's command ended with this status
  over,      ///< the server's command ended with this status: all is over
  bye,       ///< the worker's rank has ended what it started; the server's: all have, and may leave
  stop       ///< a rank was asked to stop, or failed: all end with this status
};

struct Frame {
  FrameKind kind = FrameKind::alive;
  std::uint32_t connection = 0;  ///< numbered by the rank where it began, from 1 on; 0: of no connection
  std::uint32_t value = 0;       ///< bytes of a credit; status of a command or of all
  std::string data{};
};
using SendFrame = std::function<void(const Frame&)>;

inline constexpr std::size_t frameHeader = 12, maxFrameData = 32768, maxFrame = frameHeader + maxFrameData;
/// Bytes of a connection that may be on their way or wait at the other end, in each direction.
inline constexpr std::uint32_t creditWindow = 1U << 18;

/// As a message: 'P' 'T', version, kind, then connection and value (of data: its size) as 32 bits with the
/// lowest byte first, then the data.
std::string encodeFrame(const Frame& frame);
/// The frame that is the whole message. Throws std::invalid_argument, one line, for one that is none.
Frame decodeFrame(std::string_view message);

}  // namespace plumbline::tunnel
