#include "Aliases.h"

#include <stdexcept>
#include <string_view>

#include "framework/FileLines.h"

namespace plumbline::rdb {

Aliases Aliases::read(const std::string& path) {
  FileLines in(path);
  Aliases aliases;
  int number = 0;
  for (std::string line; in.next(line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    const auto bar = line.find('|');
    if (bar == 0 || bar == std::string::npos || line.size() > 1000)
      throw std::runtime_error(path + ':' + std::to_string(number) +
                               ": an alias is written A|B, as r:|representation:");
    aliases.add(line.substr(0, bar), line.substr(bar + 1));
  }
  return aliases;
}

std::string Aliases::expand(const std::string& line) const {
  std::string result;
  for (std::size_t at = 0; at < line.size();) {
    bool replaced = false;
    if (at == 0 || line[at - 1] == ' ') {
      for (const auto& [from, to] : aliases_) {
        if (std::string_view(line).substr(at).starts_with(from)) {
          result += to;
          at += from.size();
          replaced = true;
          break;
        }
      }
    }
    if (!replaced) result += line[at++];
  }
  return result;
}

}  // namespace plumbline::rdb
