#pragma once
#include <string>

namespace plumbline {

/// A TCP connection, or in one line why there is none.
struct ConnectedSocket {
  int descriptor = -1;  ///< non-blocking, closed by exec; the caller's to close. -1: there is none
  std::string problem{};
};

/// Connects to a host, by name or number, within the time [s]. Ends at once ("Operation canceled") when
/// `stopDescriptor` becomes readable, also while a name server does not answer; -1: nothing ends it.
ConnectedSocket connectSocket(const std::string& host, int port, double seconds, int stopDescriptor = -1);

}  // namespace plumbline
