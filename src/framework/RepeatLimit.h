#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumbline {

/// Limits similar messages in a log: of each kind at most some a second, then only their number. Memory is
/// bounded: kinds beyond maxKinds count as one. Times are of any steady clock [s]. Not shared between
/// threads.
class RepeatLimit {
public:
  explicit RepeatLimit(unsigned perSecond, std::size_t maxKinds = 64)
      : perSecond_(perSecond), maxKinds_(maxKinds) {}

  /// How many of that kind were kept back since the last that was let through (mostly 0); nothing: keep this
  /// one back, too.
  std::optional<unsigned> admit(std::string_view kind, double now);
  /// The kinds of which some were kept back and none came for a second, and how many; each is reported once.
  std::vector<std::pair<std::string, unsigned>> takeOverdue(double now);

private:
  struct Kind {
    double since = 0;  ///< when its second began
    unsigned said = 0, keptBack = 0;
  };
  void forgetQuiet(double now);

  unsigned perSecond_;
  std::size_t maxKinds_;
  std::map<std::string, Kind, std::less<>> kinds_;
};

/// A message without the numbers of its addresses: what only comes from another port is of one kind.
std::string kindOfMessage(std::string_view message);

}  // namespace plumbline
