#include "gap/run/Cell.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace plumbline::gap {
namespace {

constexpr auto none = std::string_view::npos;

/// Where the cell at the beginning of a text ends; `open`: its quotes do not.
std::size_t endOfCell(std::string_view text, char separator, bool lists, bool& open) {
  std::size_t at = 0;
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t') && text[at] != separator) ++at;
  if (at == text.size()) return none;
  if (text[at] == '"' && separator != '"') {
    for (std::size_t close = at + 1; (close = text.find('"', close)) != none; close += 2)
      if (close + 1 == text.size() || text[close + 1] != '"') return text.find(separator, close);
    open = lists;
    return lists ? none : text.find(separator, at);
  }
  if (lists && text[at] == '[')
    if (const std::size_t close = text.find(']', at); close != none) at = close;
  return text.find(separator, at);
}

/// Takes a beginning off a text, if it is there.
bool take(std::string_view& text, std::string_view beginning) {
  if (!text.starts_with(beginning)) return false;
  text.remove_prefix(beginning.size());
  return true;
}

/// What is within the brackets; the text itself if it has none. False for brackets that do not fit.
bool takeBrackets(std::string_view& text, bool& bracketed) {
  bool array = take(text, "array(");
  for (const char* type : {"'d', ", "'f', "}) array = take(text, type) || array;
  bracketed = array || text.starts_with('[') || text.starts_with('(');
  if (!bracketed) return true;
  if (array) {
    const std::size_t close = text.rfind(']');
    if (close == none || !text.ends_with(')')) return false;
    text = text.substr(0, close + 1);
  }
  const bool round = text.starts_with('(');
  if (text.size() < 2 || text.back() != (round ? ')' : ']') || (!round && text.front() != '[')) return false;
  text = text.substr(1, text.size() - 2);
  return true;
}

}  // namespace

std::string_view trimmedCell(std::string_view text) {
  const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return text;
}

bool numberOf(std::string_view text, double& x) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(x);
}

bool splitCells(std::string_view line, char separator, bool lists, std::vector<std::string_view>& cells) {
  cells.clear();
  bool open = false;
  for (;;) {
    const std::size_t end = endOfCell(line, separator, lists, open);
    cells.push_back(trimmedCell(line.substr(0, end)));
    if (end == none) return !open;
    line.remove_prefix(end + 1);
  }
}

bool listOf(std::string_view text, const std::vector<std::string>& missing, std::size_t longest,
            std::vector<double>& list) {
  list.clear();
  text = trimmedCell(text);
  bool bracketed = false;
  if (!takeBrackets(text, bracketed)) return false;
  // "1,5" without brackets is a number with a decimal comma.
  const std::string_view between = bracketed ? " \t\r\n,;" : " \t\r\n;";
  for (;;) {
    const std::size_t begin = text.find_first_not_of(between);
    if (begin == none) break;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(between));
    double x = std::numeric_limits<double>::quiet_NaN();
    if (std::ranges::find(missing, word) == missing.end() && !numberOf(word, x)) return false;
    if (list.size() == longest) return false;
    list.push_back(x);
    text.remove_prefix(word.size());
  }
  return bracketed || list.size() > 1;
}

}  // namespace plumbline::gap
