#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace plumbline::test {

/// Messages recorded from the league's server, one a line: tests/data/samples/<name>.txt.gz. Tests run in the
/// root.
inline std::vector<std::string> samples(const std::string& name) {
  const std::string command = "gzip -dc tests/data/samples/" + name + ".txt.gz";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string all;
  char buffer[1 << 14];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) all.append(buffer, n);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end; (end = all.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(all.substr(begin, end - begin));
  return lines;
}

}  // namespace plumbline::test
