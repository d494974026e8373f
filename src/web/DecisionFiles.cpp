#include "web/DecisionFiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "field/TeamSize.h"
#include "framework/ReadFile.h"

namespace plumbline::web {
namespace {

using nlohmann::json;

constexpr std::size_t mostBytes = std::size_t{8} << 20, longestLine = 1000, longestAction = 40;
constexpr std::size_t columnsBefore = 3, columnsOfAction = 5;
constexpr double latest = 1e6;     // clock [s]
constexpr double farthest = 1000;  // [m]
constexpr double mostWorth = 10;   // value, to both sides
constexpr std::string_view firstColumns = "clock,x,y,action1,";

std::vector<std::string_view> cut(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Reads the lines of one file; each mistake names it.
class DecisionReader {
public:
  DecisionReader(std::string file, bool left) : file_(std::move(file)), sign_(left ? 1 : -1) {}

  json lines() {
    const std::string text = bytes();
    json result = json::array();
    std::string_view rest = text;
    std::size_t columns = 0;
    // What has no end of line was cut off.
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      ++line_;
      const std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end + 1);
      if (line.size() > longestLine) fail("the line is too long");
      const std::vector<std::string_view> cells = cut(line, ',');
      if (line_ == 1) {
        if (!line.starts_with(firstColumns)) fail("this is no file of bin/agent --decisions");
        columns = cells.size();
        continue;
      }
      if (cells.size() != columns) fail(fmt::format("{} columns, not {}", cells.size(), columns));
      result.push_back(decision(cells));
    }
    if (line_ == 0) fail("this is no file of bin/agent --decisions");
    return result;
  }

private:
  std::string bytes() const {
    try {
      return readFile(file_, mostBytes);
    } catch (const FileProblem& problem) {
      throw std::runtime_error(file_ + ": " + problem.what());
    }
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(fmt::format("{}:{}: {}", file_, std::max(line_, 1), why));
  }
  double number(std::string_view cell, double least, double most) const {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !(value >= least && value <= most))
      fail(fmt::format("\"{}\" is no number from {:g} to {:g}", printable(cell), least, most));
    return value;
  }
  double place(std::string_view cell) const { return sign_ * number(cell, -farthest, farthest) + 0.0; }
  static std::string printable(std::string_view cell) {
    std::string text;
    for (const char c : cell.substr(0, longestAction)) text += c >= ' ' && c <= '~' && c != '"' ? c : '?';
    return text;
  }
  std::string action(std::string_view cell) const {
    const bool word = std::ranges::all_of(cell, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
             c == '-';
    });
    if (cell.size() > longestAction || !word) fail(fmt::format("\"{}\" is no action", printable(cell)));
    return std::string(cell);
  }
  json decision(const std::vector<std::string_view>& cells) const {
    json actions = json::array();
    for (std::size_t i = columnsBefore; i + columnsOfAction <= cells.size(); i += columnsOfAction) {
      if (cells[i].empty()) continue;
      actions.push_back({action(cells[i]), place(cells[i + 1]), place(cells[i + 2]),
                         number(cells[i + 3], -mostWorth, mostWorth), number(cells[i + 4], 0, 1)});
    }
    if (actions.empty()) fail("no action");
    return {number(cells[0], 0, latest), place(cells[1]), place(cells[2]), std::move(actions)};
  }

  std::string file_;
  double sign_;
  int line_ = 0;
};

}  // namespace

std::string gameDecisions(const std::string& folder) {
  json players = json::array();
  for (const bool left : {true, false})
    for (int number = 1; number <= teamSize; ++number) {
      const char* side = left ? "left" : "right";
      const std::string file = fmt::format("{}/{}-{}.csv", folder, side, number);
      std::error_code none;
      if (!std::filesystem::exists(file, none)) continue;
      players.push_back({{"side", side}, {"unum", number}, {"lines", DecisionReader(file, left).lines()}});
    }
  if (players.empty())
    throw std::runtime_error(folder + ": no decisions are in it; bin/agent --decisions " + folder +
                             " writes them");
  return players.dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace plumbline::web
