#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::gap {

/// A table of numbers, read from text.
struct Table {
  std::vector<std::string> names;            ///< in the file's order
  std::vector<std::vector<double>> columns;  ///< one per name; NaN if a cell was empty
  /// For columns with a cell that is no number: line and shortened text of the first such cell.
  struct BadCell {
    std::size_t line = 0;
    std::string text;
  };
  std::map<std::string, BadCell> bad;
  /// Columns with lists in their cells, and how long these are. The numbers are in the columns `NAME[0]`,
  /// `NAME[1]`, ... behind all others; NAME is no column.
  std::map<std::string, std::size_t> lists;
  std::vector<std::string> notes;  ///< how the text was read where that was not said: comments, commas
};

/// Limits: characters of one line, columns, cells in all.
constexpr std::size_t maxLineLength = 1 << 17, maxColumns = 1024, maxCells = 40'000'000;

/// Text of a cell or name for a message: its beginning, only printable ASCII.
std::string shownText(std::string_view text);

/// Whether a column may have this name: it is short, and shownText shows its beginning unchanged.
bool canBeName(const std::string& name);

/// How a table is written.
struct TableForm {
  char separator = ',';
  std::vector<std::string> missing = {};  ///< words for an empty cell
  /// Cells may hold lists (Cell.h). A quoted cell may then go over several lines, as pandas writes long
  /// arrays. All lists of a column are equally long; an empty cell is a lost list.
  bool lists = false;
  /// As other programs write tables: lines that begin with # are left out, and if the separator is no comma,
  /// numbers may have decimal commas. Names that stand in a comment right above the numbers count.
  bool foreign = false;
};

/// Reads a table, plain or gzip: a header line, then as many cells a line. Throws RunError: unreadable, cut
/// short, a name twice, another number of cells, too large, fewer than two lines of data.
Table readTable(const std::string& path, const TableForm& form = {});

}  // namespace plumbline::gap
