#pragma once
#include <algorithm>
#include <string>

namespace plumbline {

/// A text as comment lines of a YAML file, with the line's end after the last one.
inline std::string commentLines(const std::string& text) {
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines += "# " + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return lines;
}

}  // namespace plumbline
