#include "gap/run/Table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "framework/StopSignal.h"
#include "framework/TextLines.h"
#include "gap/run/Cell.h"
#include "gap/run/Run.h"

namespace plumbline::gap {
namespace {

constexpr std::size_t longestShown = 30;
constexpr int mostLinesOfACell = 1000;
constexpr double lostCell = std::numeric_limits<double>::quiet_NaN();

class TableReader {
public:
  TableReader(const std::string& path, const TableForm& form) : lines_(path, maxLineLength), form_(form) {}

  Table read() {
    const std::string& path = lines_.path();
    std::string_view text;
    if (!nextLine(text) || text.empty())
      throw RunError(path + ": is empty; the first line names the columns");
    const bool named = takeNamesOfComment(text);
    if (!named) readHeader(text);
    while (named && rows_ == 0 ? splitRow(text) : nextRow()) {
      StopSignal::throwIfCaught();
      if (cells_.size() != ofHeader_)
        lines_.fail("has " + std::to_string(cells_.size()) + " cells, the header has " +
                    std::to_string(ofHeader_) + otherSeparator_);
      ++rows_;
      for (std::size_t c = 0; c < ofHeader_; ++c) take(c);
      if (rows_ * table_.names.size() > maxCells)
        lines_.fail("more than " + std::to_string(maxCells) + " cells; cut the run into shorter ones");
    }
    if (rows_ < 2)
      throw RunError(path + ": has " + std::to_string(rows_) + " lines of data; a run needs two at least");
    removeLists();
    noteForm();
    return std::move(table_);
  }

private:
  /// The next line that is no comment.
  bool nextLine(std::string_view& text) {
    while (lines_.next(text)) {
      if (lines_.line() == 1 && text.substr(0, 3) == "\xef\xbb\xbf")
        text.remove_prefix(3);  // byte order mark
      if (!form_.foreign || !text.starts_with('#')) return true;
      ++comments_;
      comment_ = text.substr(1);
      commentLine_ = lines_.line();
    }
    return false;
  }

  /// Names as numpy writes them: in a comment right above the first line, which holds numbers alone.
  bool takeNamesOfComment(std::string_view first) {
    if (commentLine_ == 0 || commentLine_ + 1 != lines_.line()) return false;
    std::vector<std::string_view> names;
    splitCells(comment_, form_.separator, false, names);
    if (!splitCells(first, form_.separator, form_.lists, cells_) || cells_.size() != names.size())
      return false;
    double x = 0;
    if (!std::ranges::all_of(cells_, [&](std::string_view cell) { return isNumber(cell, x); })) return false;
    const std::string comment = comment_;
    readHeader(comment);
    --comments_;
    table_.notes.push_back("the names of the columns are those of the comment in line " +
                           std::to_string(commentLine_));
    return true;
  }

  /// A number, also with a decimal comma where that can be one.
  bool isNumber(std::string_view cell, double& x) {
    if (numberOf(cell, x)) {
      if (firstPoint_ == 0 && cell.find('.') != std::string_view::npos) firstPoint_ = lines_.line();
      return true;
    }
    if (!form_.foreign || form_.separator == ',' || cell.size() > 40) return false;
    const std::size_t comma = cell.find(',');
    if (comma == std::string_view::npos || cell.find('.') != std::string_view::npos) return false;
    std::string text(cell);
    text[comma] = '.';
    if (!numberOf(text, x)) return false;
    if (firstComma_ == 0) firstComma_ = lines_.line();
    return true;
  }

  void noteForm() {
    if (comments_ > 0)
      table_.notes.push_back("lines that begin with # are left out: " + std::to_string(comments_));
    if (firstComma_ == 0) return;
    if (firstPoint_ > 0)
      throw RunError(lines_.path() + ": has a decimal comma in line " + std::to_string(firstComma_) +
                     " and a decimal point in line " + std::to_string(firstPoint_) +
                     "; write all numbers in one way");
    table_.notes.emplace_back("numbers are read with decimal commas");
  }

  void readHeader(std::string_view text) {
    if (!splitCells(text, form_.separator, form_.lists, cells_)) lines_.fail("the quotes of a name are open");
    if (cells_.size() > maxColumns) lines_.fail("more than " + std::to_string(maxColumns) + " columns");
    for (const std::string_view cell : cells_) {
      if (cell.empty()) lines_.fail("column " + std::to_string(table_.names.size() + 1) + " has no name");
      addColumn(std::string(cell));
    }
    ofHeader_ = table_.names.size();
    for (const auto& [separator, shown] : {std::pair(';', ";"), std::pair('\t', "tab"), std::pair(',', ",")})
      if (form_.foreign && ofHeader_ == 1 && text.find(separator) != std::string_view::npos)
        otherSeparator_ = std::string("; if cells end with another character, write separator: \"") + shown +
                          "\" into the map";
    elements_.resize(ofHeader_);
  }

  void addColumn(const std::string& name) {
    if (!canBeName(name)) lines_.fail("\"" + shownText(name) + "\" is not allowed as the name of a column");
    if (!seen_.insert(name).second) lines_.fail("column " + name + " occurs twice; leave one out");
    if (ofHeader_ > 0 && table_.names.size() - ofHeader_ >= maxColumns)
      lines_.fail("more than " + std::to_string(maxColumns) + " numbers in the lists of its cells");
    table_.names.push_back(name);
    table_.columns.emplace_back();
  }

  /// The next line's cells; further lines as long as quotes are open.
  bool nextRow() {
    std::string_view text;
    do {
      if (!nextLine(text)) return false;
    } while (text.empty());
    return splitRow(text);
  }

  bool splitRow(std::string_view text) {
    if (splitCells(text, form_.separator, form_.lists, cells_)) return true;
    const std::size_t first = lines_.line();
    joined_ = text;
    for (int more = 0;; ++more) {
      if (more == mostLinesOfACell || !lines_.next(text))
        throw RunError(lines_.path() + ":" + std::to_string(first) +
                       ": the quotes of a cell do not end; close them, or take them out");
      joined_ += '\n';
      joined_ += text;
      if (joined_.size() > maxLineLength)
        lines_.fail("the cell that begins in line " + std::to_string(first) + " is longer than " +
                    std::to_string(maxLineLength) + " characters");
      if (text.find('"') != std::string_view::npos &&
          splitCells(joined_, form_.separator, form_.lists, cells_))
        return true;
    }
  }

  /// Takes the cell of a column of the header.
  void take(std::size_t c) {
    const std::string_view cell = cells_[c];
    const bool empty = cell.empty() || std::ranges::find(form_.missing, cell) != form_.missing.end();
    double x = lostCell;
    if (!empty && !isNumber(cell, x)) x = lostCell;
    const bool number = !std::isnan(x);
    const Elements& elements = elements_[c];
    if (!empty && !number && form_.lists && listOf(cell, form_.missing, maxColumns, list_)) {
      if (elements.count == 0 && !elements.numbers && !list_.empty()) makeElements(c);
      if (list_.empty() || list_.size() == elements.count) return addList(c);
    }
    if (elements.count > 0) {
      if (!empty) markBad(c, cell);
      list_.clear();
      return addList(c);
    }
    if (!empty && !number) markBad(c, cell);
    elements_[c].numbers |= !empty;
    table_.columns[c].push_back(x);
  }

  /// A column's first list: its elements become columns, lost so far.
  void makeElements(std::size_t c) {
    const std::string name = table_.names[c];
    Elements& elements = elements_[c];
    elements.first = table_.names.size();
    elements.count = list_.size();
    table_.lists[name] = elements.count;
    for (std::size_t i = 0; i < elements.count; ++i) {
      addColumn(name + "[" + std::to_string(i) + "]");
      table_.columns.back().assign(rows_ - 1, lostCell);
    }
  }

  void addList(std::size_t c) {
    table_.columns[c].push_back(lostCell);
    for (std::size_t i = 0; i < elements_[c].count; ++i)
      table_.columns[elements_[c].first + i].push_back(list_.empty() ? lostCell : list_[i]);
  }

  void markBad(std::size_t c, std::string_view cell) {
    const Table::BadCell bad{lines_.line(), shownText(cell)};
    const Elements& elements = elements_[c];
    if (elements.count == 0) table_.bad.try_emplace(table_.names[c], bad);
    for (std::size_t i = 0; i < elements.count; ++i)
      table_.bad.try_emplace(table_.names[elements.first + i], bad);
  }

  void removeLists() {
    for (std::size_t c = ofHeader_; c-- > 0;) {
      if (elements_[c].count == 0) continue;
      table_.names.erase(table_.names.begin() + static_cast<std::ptrdiff_t>(c));
      table_.columns.erase(table_.columns.begin() + static_cast<std::ptrdiff_t>(c));
    }
  }

  /// Columns of a list's elements; `numbers`: its cells hold no lists.
  struct Elements {
    std::size_t first = 0, count = 0;
    bool numbers = false;
  };

  TextLines lines_;
  const TableForm form_;
  Table table_;
  std::set<std::string> seen_;
  std::size_t ofHeader_ = 0, rows_ = 0;
  std::size_t comments_ = 0, commentLine_ = 0, firstComma_ = 0, firstPoint_ = 0;
  std::string comment_, otherSeparator_;
  std::vector<Elements> elements_;
  std::vector<std::string_view> cells_;
  std::vector<double> list_;
  std::string joined_;
};

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

Table readTable(const std::string& path, const TableForm& form) {
  try {
    return TableReader(path, form).read();
  } catch (const TextError& error) {
    throw RunError(error.what());
  }
}

}  // namespace plumbline::gap
