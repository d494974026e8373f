// What a Console shows, and how it completes what is typed.
#include <ncurses.h>

#include <algorithm>
#include <array>
#include <memory>

#include "Console.h"

namespace plumbline::rdb {
namespace {

/// Help of the console itself; the agent sends its own.
constexpr std::array ownCommands{"plot", "png", "quit", "run"};
constexpr std::size_t maxShown = 60;

std::string commonBeginning(const std::vector<std::string>& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto [end, other] = std::ranges::mismatch(common, word);
    common.erase(end, common.end());
  }
  return common;
}

/// At most so many columns of UTF-8.
std::string fitted(const std::string& text, int columns) {
  std::string result;
  int used = 0;
  for (const char c : text) {
    const bool begins = (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    if (begins && used == columns) break;
    used += begins ? 1 : 0;
    result += c;
  }
  return result;
}

}  // namespace

void Console::complete() {
  const std::string before = input_.substr(0, cursor_);
  const auto begin = before.find_last_of(' ') + 1;
  const std::string word = before.substr(begin);
  auto words = wordsOf(before.substr(0, begin));
  words.push_back(word);
  const bool readable = words[0] == "plot";  // a name as behind `get`
  if (words.size() != 2 || (!readable && std::ranges::find(commands_, words[0]) == commands_.end()))
    return completed(word, completions(words), false);
  const std::string wanted = session_.expand(' ' + word).substr(1);
  const std::string ask = "complete " + (readable ? std::string("get") : words[0]) + ' ';
  const auto found = std::make_shared<std::vector<std::string>>();
  session_.ask(ask + wanted, {[found](const std::string& text) { found->push_back(text); },
                              [this, found, word, wanted, ask](bool) {
                                // A whole name goes on with its parts.
                                if (*found != std::vector{wanted}) return completed(word, *found, true);
                                const auto parts = std::make_shared<std::vector<std::string>>(*found);
                                session_.ask(ask + wanted + '.', {[parts](const std::string& text) {
                                                                    if (!text.starts_with("error: "))
                                                                      parts->push_back(text);
                                                                  },
                                                                  [this, parts, word](bool) {
                                                                    if (parts->size() > 1)
                                                                      parts->erase(parts->begin());
                                                                    completed(word, *parts, true);
                                                                  }});
                              }});
}

void Console::askCommands() {
  commands_.clear();
  session_.ask("commands", {[this](const std::string& usage) {
                              if (!usage.starts_with("error: "))
                                commands_.push_back(usage.substr(0, usage.find(' ')));
                            },
                            {}});
}

/// What the console knows without asking: commands, its plots, and the words behind a name.
std::vector<std::string> Console::completions(const std::vector<std::string>& words) const {
  std::vector<std::string> all, found;
  if (words.size() == 1) {
    all = commands_;
    all.insert(all.end(), ownCommands.begin(), ownCommands.end());
    std::ranges::sort(all);
  } else if ((words[0] == "png" && words.size() == 2) || (words[0] == "plot" && words.size() == 3)) {
    for (const auto& [name, plot] : session_.plots()) all.push_back(name);
  } else if (words[0] == "dr" && words.size() == 3) {
    all = {"off", "once"};
  } else if (words[0] == "watch" && words.size() == 3) {
    all = {"every"};
  }
  for (const std::string& each : all) {
    if (each.starts_with(words.back())) found.push_back(each);
  }
  return found;
}

void Console::completed(const std::string& word, const std::vector<std::string>& found, bool parts) {
  changed_ = true;
  const auto begin = cursor_ >= word.size() ? cursor_ - word.size() : 0;
  if (input_.substr(begin, word.size()) != word || found.empty()) return;  // typing went on
  const std::string common = commonBeginning(found);
  if (common.size() >= word.size() || parts) {
    input_.replace(begin, word.size(), common);
    cursor_ = begin + common.size();
  }
  if (found.size() == 1) {
    if (!parts && cursor_ == input_.size()) input_.insert(cursor_++, 1, ' ');
    return;
  }
  for (std::size_t i = 0; i < std::min(found.size(), maxShown); ++i) print("  " + found[i]);
  if (found.size() > maxShown) print("  ... " + std::to_string(found.size() - maxShown) + " more");
}

void Console::putLine(int row, const std::string& text, bool bold) {
  if (row < 0 || row >= LINES) return;
  if (bold) attron(A_BOLD);
  mvaddstr(row, 0, fitted(text, COLS).c_str());
  if (bold) attroff(A_BOLD);
}

void Console::draw() {
  erase();
  int row = 0;
  const int most = std::max(1, LINES - 6);
  for (const Watch& watch : watches_) {
    if (row < most) putLine(row++, watch.name + "  " + watch.value, true);
  }
  for (const auto& [name, plot] : session_.plots()) {
    const int width = std::max(8, COLS - 70);
    for (const std::string& line : plot.sparklines(static_cast<std::size_t>(width), unicode_)) {
      if (row < most) putLine(row++, line);
    }
  }
  attron(A_REVERSE);
  std::string state = " rdb " + link_.name() + (link_.connected() ? "" : "  not connected") +
                      (scroll_ > 0 ? "  (Page Down goes on)" : "");
  state.resize(std::max<std::size_t>(state.size(), static_cast<std::size_t>(COLS)), ' ');
  putLine(row++, state);
  attroff(A_REVERSE);

  const auto room = static_cast<std::size_t>(std::max(0, LINES - 1 - row));
  const std::size_t end = output_.size() - std::min(scroll_, output_.size());
  const std::size_t begin = end - std::min(end, room);
  for (std::size_t i = begin; i < end; ++i) putLine(row++, output_[i]);

  const std::string prompt = "rdb> ";
  const auto columns = static_cast<std::size_t>(std::max(10, COLS)) - prompt.size() - 1;
  const std::size_t first = cursor_ > columns ? cursor_ - columns : 0;
  putLine(LINES - 1, prompt + input_.substr(first, columns));
  move(LINES - 1, static_cast<int>(prompt.size() + cursor_ - first));
  refresh();
}

}  // namespace plumbline::rdb
