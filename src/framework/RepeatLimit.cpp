#include "framework/RepeatLimit.h"

namespace plumbline {

namespace {
constexpr double window = 1;  // [s]
}

void RepeatLimit::forgetQuiet(double now) {
  std::erase_if(kinds_, [now](const auto& entry) {
    return now - entry.second.since >= window && entry.second.keptBack == 0;
  });
}

std::optional<unsigned> RepeatLimit::admit(std::string_view name, double now) {
  auto found = kinds_.find(name);
  if (found == kinds_.end()) {
    if (kinds_.size() >= maxKinds_) forgetQuiet(now);
    if (kinds_.size() >= maxKinds_) name = "";
    found = kinds_.try_emplace(std::string(name), Kind{now}).first;
  }
  Kind& kind = found->second;
  if (now - kind.since >= window) {
    kind.since = now;
    kind.said = 0;
  }
  if (kind.said >= perSecond_) {
    ++kind.keptBack;
    return std::nullopt;
  }
  ++kind.said;
  return std::exchange(kind.keptBack, 0);
}

std::vector<std::pair<std::string, unsigned>> RepeatLimit::takeOverdue(double now) {
  std::vector<std::pair<std::string, unsigned>> overdue;
  for (auto& [name, kind] : kinds_) {
    if (kind.keptBack == 0 || now - kind.since < window) continue;
    overdue.emplace_back(name, std::exchange(kind.keptBack, 0));
    kind.since = now;
    kind.said = 0;
  }
  return overdue;
}

std::string kindOfMessage(std::string_view message) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto joins = [&](std::size_t i) {
    return i < message.size() && (message[i] == '.' || message[i] == ':');
  };
  std::string kind;
  for (std::size_t begin = 0; begin < message.size();) {
    std::size_t end = begin;
    while (end < message.size() && isDigit(message[end])) ++end;
    const bool address = end > begin && (joins(end) || (begin > 0 && joins(begin - 1)));
    if (end == begin) ++end;
    if (address)
      kind += '#';
    else
      kind += message.substr(begin, end - begin);
    begin = end;
  }
  return kind;
}

}  // namespace plumbline
