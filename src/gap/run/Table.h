#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::gap {

/// A table of numbers as text gave it.
struct Table {
  std::vector<std::string> names;            ///< in the file's order
  std::vector<std::vector<double>> columns;  ///< one per name; NaN where a cell was empty
  /// Columns with a cell that is no number: line and shortened text of the first such cell.
  struct BadCell {
    std::size_t line = 0;
    std::string text;
  };
  std::map<std::string, BadCell> bad;
};

/// Bounds of what is read: text of one line, columns, cells in all.
constexpr std::size_t maxLineLength = 1 << 17, maxColumns = 1024, maxCells = 40'000'000;

/// What of a cell or name may stand in a message: its beginning, without what is no printable ASCII.
std::string shownText(std::string_view text);

/// Whether a column may have this name: short, and its beginning is what shownText shows.
bool canBeName(const std::string& name);

/// Reads a table, plain or gzip: a header line, then as many cells a line. `missing` are words that stand for
/// an empty cell. Throws RunError: unreadable, cut short, a name twice, another number of cells, too large,
/// fewer than two lines of data.
Table readTable(const std::string& path, char separator = ',', const std::vector<std::string>& missing = {});

}  // namespace plumbline::gap
