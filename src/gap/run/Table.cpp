#include "gap/run/Table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "framework/StopSignal.h"
#include "framework/TextLines.h"
#include "gap/run/Run.h"

namespace plumbline::gap {
namespace {

constexpr std::size_t longestShown = 30;

std::string_view trim(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

void split(std::string_view text, char separator, std::vector<std::string_view>& cells) {
  cells.clear();
  for (;;) {
    const std::size_t end = text.find(separator);
    cells.push_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

bool parse(std::string_view text, double& x) {
  if (text.front() == '+' && text.size() > 1 && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(x);
}

void readHeader(TextLines& lines, std::string_view text, char separator, Table& table) {
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);  // byte order mark
  std::vector<std::string_view> cells;
  split(text, separator, cells);
  if (cells.size() > maxColumns) lines.fail("more than " + std::to_string(maxColumns) + " columns");
  std::set<std::string> seen;
  for (const std::string_view cell : cells) {
    if (cell.empty()) lines.fail("column " + std::to_string(table.names.size() + 1) + " has no name");
    const std::string name(cell);
    if (!canBeName(name)) lines.fail("\"" + shownText(name) + "\" is not allowed as the name of a column");
    if (!seen.insert(name).second) lines.fail("column " + name + " occurs twice; leave one out");
    table.names.push_back(name);
  }
}

Table readLines(TextLines& lines, char separator, const std::vector<std::string>& missing) {
  const std::string& path = lines.path();
  std::string_view text;
  if (!lines.next(text) || text.empty())
    throw RunError(path + ": is empty; the first line names the columns");
  Table table;
  readHeader(lines, text, separator, table);
  table.columns.resize(table.names.size());
  const std::size_t maxRows = maxCells / table.names.size();
  std::vector<std::string_view> cells;
  std::size_t rows = 0;
  while (lines.next(text)) {
    StopSignal::throwIfCaught();
    if (text.empty()) continue;
    split(text, separator, cells);
    if (cells.size() != table.names.size())
      lines.fail("has " + std::to_string(cells.size()) + " cells, the header has " +
                 std::to_string(table.names.size()));
    if (++rows > maxRows)
      lines.fail("more than " + std::to_string(maxCells) + " cells; cut the run into shorter ones");
    for (std::size_t c = 0; c < cells.size(); ++c) {
      double x = std::numeric_limits<double>::quiet_NaN();
      const bool empty =
          cells[c].empty() || std::find(missing.begin(), missing.end(), cells[c]) != missing.end();
      if (!empty && !parse(cells[c], x)) {
        x = std::numeric_limits<double>::quiet_NaN();
        table.bad.try_emplace(table.names[c], Table::BadCell{lines.line(), shownText(cells[c])});
      }
      table.columns[c].push_back(x);
    }
  }
  if (rows < 2)
    throw RunError(path + ": has " + std::to_string(rows) + " lines of data; a run needs two at least");
  return table;
}

}  // namespace

std::string shownText(std::string_view text) {
  std::string shown(text.substr(0, longestShown));
  std::ranges::replace_if(
      shown, [](char c) { return c < ' ' || c > '~'; }, '?');
  return shown;
}

bool canBeName(const std::string& name) {
  constexpr std::size_t longest = 200;
  return name.size() <= longest && shownText(name) == name.substr(0, longestShown);
}

Table readTable(const std::string& path, char separator, const std::vector<std::string>& missing) {
  try {
    TextLines lines(path, maxLineLength);
    return readLines(lines, separator, missing);
  } catch (const TextError& error) {
    throw RunError(error.what());
  }
}

}  // namespace plumbline::gap
