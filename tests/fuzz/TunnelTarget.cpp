// What one rank of bin/mpitunnel takes from another: a message, and messages one after the other.
#include <poll.h>

#include "fuzz/Readers.h"
#include "optimization/farm/LineSocket.h"
#include "tunnel/RankLink.h"
#include "tunnel/TunnelFrame.h"

namespace plumbline::fuzz {
namespace {

using namespace tunnel;

void tunnelFrame(std::string_view bytes) {
  refusesInOneLine([&] {
    const Frame frame = decodeFrame(bytes);
    require(encodeFrame(frame) == bytes, "a frame is written otherwise than it was read");
  });
}

/// A message each: a byte says how long it is, with all of the header but its size and its data given.
void tunnelLink(std::string_view bytes) {
  std::size_t sent = 0, taken = 0;
  RankLink link([&](const Frame& frame) {
    require(encodeFrame(frame).size() <= maxFrame, "too large a frame");
    ++sent;
  });
  link.connectTo(1, 1e9);  // nobody listens there, as no user may
  double now = 0;
  const auto serve = [&] {
    std::vector<pollfd> watched;
    link.watch(watched);
    poll(watched.data(), watched.size(), 0);
    require(link.serve(watched, now += 0.01) == watched.size(), "another number of sockets than are watched");
  };
  refusesInOneLine([&] {
    while (bytes.size() >= 3) {
      const auto kind = static_cast<FrameKind>(static_cast<unsigned char>(bytes[0]) % 12);
      Frame frame{
          kind, static_cast<unsigned char>(bytes[1]), static_cast<unsigned char>(bytes[2]) * 1100U, {}};
      if (kind == FrameKind::data) frame.data.assign(frame.value % (maxFrameData + 9), 'x');
      bytes.remove_prefix(3);
      link.take(decodeFrame(encodeFrame(frame)), now);
      ++taken;
      require(link.connections() <= taken, "more connections than were opened");
      if (taken % 4 == 0) serve();
    }
  });
}

std::vector<std::string> tunnelFrameSeeds() {
  std::vector<std::string> all;
  for (const Frame& frame :
       {Frame{FrameKind::open, 1}, Frame{FrameKind::data, 7, 0, "bytes"}, Frame{FrameKind::end, 2},
        Frame{FrameKind::reset, 300}, Frame{FrameKind::credit, 4, 70000}, Frame{FrameKind::alive},
        Frame{FrameKind::ended, 0, 2}, Frame{FrameKind::over, 0, 130}, Frame{FrameKind::bye}})
    all.push_back(encodeFrame(frame));
  return all;
}
std::vector<std::string> tunnelLinkSeeds() {
  return {std::string("\1\1\0\2\1\2\2\1\5\3\1\0", 12),
          std::string("\1\1\0\1\2\0\2\2\x1d\4\1\0\2\2\3\3\2\0", 18), std::string("\1\1\0\2\1\x1d\5\1\1", 9)};
}

const Registered tunnelFrameTarget({"tunnelFrame", tunnelFrame, tunnelFrameSeeds, 15000});
const Registered tunnelLinkTarget({"tunnelLink", tunnelLink, tunnelLinkSeeds, 2000});

}  // namespace
}  // namespace plumbline::fuzz
