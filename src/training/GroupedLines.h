#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>

namespace plumbline::training {

/// Lines of a YAML file for numbers with paths as ParameterList::visit names them: those of a group,
/// "walk.maxTurn", stand together below its name; "leaveTolerances" is in none. `digits` are written.
class GroupedLines {
public:
  explicit GroupedLines(std::string indent, int digits = 5) : indent_(std::move(indent)), digits_(digits) {}

  void add(const std::string& path, double value) {
    const std::size_t dot = path.find('.');
    const std::string group = dot == std::string::npos ? "" : path.substr(0, dot);
    if (group != group_ && !group.empty()) text += indent_ + group + ":\n";
    group_ = group;
    text += indent_ + (group.empty() ? path : "  " + path.substr(dot + 1)) +
            fmt::format(": {:.{}g}\n", value, digits_);
    ++count;
  }

  std::string text;
  std::size_t count = 0;

private:
  std::string indent_, group_;
  int digits_;
};

}  // namespace plumbline::training
