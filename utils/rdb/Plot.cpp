#include "Plot.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "framework/WriteFile.h"

namespace plumbline::rdb {
namespace {

constexpr const char* blocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr const char* plainBlocks[] = {"_", ".", "-", "~", "=", "+", "*", "#"};
constexpr std::size_t nameWidth = 40;

std::string number(double value, int digits = 4) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.*g", digits, value);
  return text;
}

std::string inQuotes(std::string text) {
  std::erase_if(text, [](char c) { return c == '"' || c == '\\' || c == '\n' || c == '`'; });
  return '"' + text + '"';
}

}  // namespace

void Plot::add(const std::string& series, double value) {
  auto& values = series_[series];
  values.push_back(value);
  while (values.size() > count_) values.pop_front();
}

bool Plot::full() const {
  return std::ranges::all_of(series_, [&](const auto& entry) { return entry.second.size() >= count_; });
}

std::vector<std::string> Plot::sparklines(std::size_t width, bool unicode) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& [name, values] : series_) {
    for (const double value : values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  std::vector<std::string> lines;
  for (const auto& [name, values] : series_) {
    std::string line = name.size() > nameWidth ? "..." + name.substr(name.size() - nameWidth + 3) : name;
    line.append(nameWidth - line.size() + 1, ' ');
    if (values.empty()) {
      lines.push_back(line + "no value yet");
      continue;
    }
    const auto [least, most] = std::ranges::minmax(values);
    line += '[' + number(least) + ", " + number(most) + "] " + number(values.back()) + "  ";
    const std::size_t bars = std::min(width, values.size());
    for (std::size_t i = 0; i < bars; ++i) {
      const double value = values[values.size() * (i + 1) / bars - 1];
      const double height = high > low ? (value - low) / (high - low) : 0.5;
      const auto step = std::min<std::size_t>(7, static_cast<std::size_t>(8 * height));
      line += unicode ? blocks[step] : plainBlocks[step];
    }
    lines.push_back(line);
  }
  return lines;
}

std::string Plot::script(const std::string& title) const {
  std::string script = "set grid\nset title " + inQuotes(title) +
                       " noenhanced\nset key outside below noenhanced\nset xlabel \"value\"\nplot ";
  bool first = true;
  for (const auto& [name, values] : series_) {
    if (values.empty()) continue;  // gnuplot stops at one without points
    script += std::string(first ? "" : ", ") + "'-' with lines linewidth 2 title " + inQuotes(name);
    first = false;
  }
  if (first) return {};
  script += '\n';
  for (const auto& [name, values] : series_) {
    if (values.empty()) continue;
    for (const double value : values) script += number(value, 12) + '\n';  // a time goes on evenly
    script += "e\n";
  }
  return script;
}

void Plot::writePng(const std::string& path, const std::string& title) const {
  const std::string partial = path + ".part";
  const std::string plot = script(title);
  if (plot.empty()) throw std::runtime_error(path + ": no value has come yet");
  const std::string whole =
      "set terminal pngcairo size 900,500\nset output " + inQuotes(partial) + '\n' + plot;
  const std::string scriptPath = path + ".gnuplot";
  writeFile(scriptPath, whole);
  const std::string command =
      "command -v gnuplot > /dev/null || exit 127; timeout 30 gnuplot \"$0\" 2> /dev/null";
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), scriptPath.c_str(), static_cast<char*>(nullptr));
    _exit(126);
  }
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  std::error_code ignored;
  std::filesystem::remove(scriptPath, ignored);
  if (child < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    std::filesystem::remove(partial, ignored);
    throw std::runtime_error(WIFEXITED(status) && WEXITSTATUS(status) == 127
                                 ? path + ": gnuplot draws pictures and is not there: install gnuplot-nox"
                                 : path + ": gnuplot could not draw it");
  }
  std::filesystem::rename(partial, path);
}

}  // namespace plumbline::rdb
