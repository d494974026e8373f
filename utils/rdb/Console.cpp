#include "Console.h"

#include <langinfo.h>
#include <ncurses.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "framework/FileLines.h"
#include "framework/SteadyClock.h"

namespace plumbline::rdb {
namespace {

constexpr std::size_t maxOutput = 5000, maxInput = 4000, maxScript = 10000;
constexpr double tryEvery = 1, drawEvery = 0.05;
constexpr int keyControlA = 1, keyControlD = 4, keyControlE = 5, keyTab = 9, keyControlK = 11,
              keyControlL = 12, keyControlU = 21, keyControlW = 23, keyDelete = 127;

}  // namespace

Console::Console(Link& link, Session& session, History& history, const StopSignal& stop)
    : link_(link), session_(session), history_(history), stop_(stop) {
  if (!isatty(STDOUT_FILENO) || !isatty(STDIN_FILENO))
    throw std::runtime_error("this is no terminal; --exec runs one command");
  screen_ = newterm(nullptr, stdout, stdin);
  if (!screen_) throw std::runtime_error("the terminal is unknown: set TERM, e.g. to xterm, or use --exec");
  cbreak();
  noecho();
  nodelay(stdscr, TRUE);
  keypad(stdscr, TRUE);
  unicode_ = std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
  place_ = history_.lines().size();
  session_.other = [this](const std::string& line) { print(line); };
}

Console::~Console() {
  if (!screen_) return;
  endwin();
  delscreen(static_cast<SCREEN*>(screen_));
}

void Console::print(const std::string& line) {
  std::string clean = line;
  std::ranges::replace_if(
      clean, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  output_.push_back(clean);
  if (output_.size() > maxOutput) output_.pop_front();
  changed_ = true;
}

void Console::keepConnected() {
  if (link_.connected()) return;
  if (wasConnected_) {
    wasConnected_ = false;
    announced_ = true;
    print("connection lost; trying again");
    session_.lost();
  }
  if (steadySeconds() < nextTry_) return;
  nextTry_ = steadySeconds() + tryEvery;
  const std::string why = link_.connect(tryEvery);
  if (why.empty()) {
    print((announced_ ? "back at " : "connected to ") + link_.name());
    wasConnected_ = true;
    session_.resume();
    askCommands();
  } else if (!announced_) {
    announced_ = true;
    print(why + "; trying again");
  }
}

void Console::showWindows() {
  if (!PlotWindow::possible()) return;
  std::erase_if(windows_, [this](const auto& entry) { return !session_.plots().contains(entry.first); });
  for (const auto& [name, plot] : session_.plots()) {
    PlotWindow& window = windows_.try_emplace(name, name).first->second;
    window.show(plot);
    if (const std::string problem = window.problem(); !problem.empty())
      print("plot " + name + ": " + problem);
  }
}

void Console::run() {
  print("help lists the commands, Tab completes, Ctrl-C ends");
  double drawn = 0;
  while (!stop_.requested() && !ends_) {
    keepConnected();
    for (int pressed = 0; (pressed = getch()) != ERR;) key(pressed);
    session_.receive(0);
    runScript();
    showWindows();
    if (changed_ && steadySeconds() - drawn >= drawEvery) {
      draw();
      drawn = steadySeconds();
      changed_ = false;
    }
    pollfd descriptors[] = {
        {STDIN_FILENO, POLLIN, 0}, {stop_.fileDescriptor(), POLLIN, 0}, {link_.descriptor(), POLLIN, 0}};
    poll(descriptors, 3, changed_ || !script_.empty() ? static_cast<int>(1000 * drawEvery) : 200);
    if (descriptors[0].revents & POLLHUP) return;
  }
}

void Console::key(int pressed) {
  changed_ = true;
  switch (pressed) {
    case KEY_LEFT:
      cursor_ -= cursor_ > 0 ? 1 : 0;
      return;
    case KEY_RIGHT:
      cursor_ += cursor_ < input_.size() ? 1 : 0;
      return;
    case KEY_HOME:
    case keyControlA:
      cursor_ = 0;
      return;
    case KEY_END:
    case keyControlE:
      cursor_ = input_.size();
      return;
    case KEY_UP:
      return browse(-1);
    case KEY_DOWN:
      return browse(1);
    case KEY_PPAGE:
      scroll_ = std::min(scroll_ + static_cast<std::size_t>(LINES / 2), output_.size());
      return;
    case KEY_NPAGE:
      scroll_ -= std::min(scroll_, static_cast<std::size_t>(LINES / 2));
      return;
    case KEY_BACKSPACE:
    case keyDelete:
    case '\b':
      if (cursor_ > 0) input_.erase(--cursor_, 1);
      return;
    case KEY_DC:
      if (cursor_ < input_.size()) input_.erase(cursor_, 1);
      return;
    case keyControlU:
      input_.erase(0, cursor_);
      cursor_ = 0;
      return;
    case keyControlW: {  // the word before the cursor, and the spaces behind it
      const auto word = cursor_ == 0 ? std::string::npos : input_.find_last_not_of(' ', cursor_ - 1);
      const auto space = word == std::string::npos ? word : input_.find_last_of(' ', word);
      const std::size_t begin = space == std::string::npos ? 0 : space + 1;
      input_.erase(begin, cursor_ - begin);
      cursor_ = begin;
      return;
    }
    case keyControlK:
      input_.erase(cursor_);
      return;
    case keyControlD:
      ends_ = input_.empty();
      return;
    case keyControlL:
      clearok(stdscr, TRUE);
      return;
    case keyTab:
      return complete();
    case '\n':
    case '\r':
    case KEY_ENTER:
      return enter();
    default:
      if (pressed >= 0x20 && pressed < 0x7f && input_.size() < maxInput)
        input_.insert(cursor_++, 1, static_cast<char>(pressed));
  }
}

void Console::browse(int direction) {
  const auto& lines = history_.lines();
  if (place_ == lines.size()) typed_ = input_;
  if (direction < 0 && place_ == 0) return;
  if (direction > 0 && place_ >= lines.size()) return;
  place_ = direction < 0 ? place_ - 1 : place_ + 1;
  input_ = place_ < lines.size() ? lines[place_] : typed_;
  cursor_ = input_.size();
}

void Console::enter() {
  const std::string line = input_;
  input_.clear();
  cursor_ = scroll_ = 0;
  if (line.find_first_not_of(' ') == std::string::npos) return;
  history_.add(line);
  place_ = history_.lines().size();
  print("> " + line);
  submit(session_.expand(line));
}

void Console::submit(const std::string& line) {
  const auto words = wordsOf(line);
  try {
    if (local(words, line)) return;
  } catch (const std::exception& error) {
    return print(std::string("error: ") + error.what());
  }
  if (!link_.connected()) return print("error: not connected to " + link_.name());
  asked_ = session_.ask(line, {[this](const std::string& text) {
                                 asked_ = 0;
                                 print(text);
                               },
                               [this](bool lost) {
                                 asked_ = 0;
                                 if (lost) print("error: the connection was lost before the answer came");
                               }});
}

bool Console::local(const std::vector<std::string>& words, const std::string& line) {
  if (words[0] == "quit" || words[0] == "exit") {
    ends_ = true;
  } else if (words[0] == "plot" && words.size() > 1 && words[1] == "off") {
    session_.endPlots(words.size() > 2 ? words[2] : "");
  } else if (words[0] == "plot") {
    session_.plot(words, [this](const std::string& why) { print("error: " + why); });
  } else if (words[0] == "png") {
    png(words);
  } else if (words[0] == "run") {
    if (words.size() != 2) throw std::runtime_error("run FILE");
    begin(words[1]);
  } else if (words[0] == "watch" && words.size() > 1) {
    watch(words, line);
  } else if (words[0] == "unwatch") {
    unwatch(words.size() > 1 ? words[1] : "");
  } else {
    return false;
  }
  return true;
}

void Console::png(const std::vector<std::string>& words) {
  if (words.size() != 3) throw std::runtime_error("png WINDOW FILE");
  const auto found = session_.plots().find(words[1]);
  if (found == session_.plots().end()) throw std::runtime_error("no plot is called " + words[1]);
  found->second.writePng(words[2], words[1]);
  print("wrote " + words[2]);
}

void Console::begin(const std::string& script) {
  FileLines in(script);
  std::deque<std::string> lines;
  for (std::string line; in.next(line);) {
    if (lines.size() >= maxScript) throw std::runtime_error(script + ": more than 10000 commands");
    if (line.find_first_not_of(' ') != std::string::npos && line[0] != '#') lines.push_back(line);
  }
  script_.insert(script_.begin(), lines.begin(), lines.end());
  if (script_.size() > maxScript) {
    script_.clear();
    throw std::runtime_error(script + ": it runs itself");
  }
}

void Console::runScript() {
  // One command after the other: an order given at once could overtake what a cycle has to answer.
  while (!script_.empty() && asked_ == 0 && steadySeconds() >= scriptWaits_) {
    const std::string line = script_.front();
    script_.pop_front();
    print("> " + line);
    const std::string command = session_.expand(line);
    const auto words = wordsOf(command);
    if (words[0] != "sleep") {
      submit(command);
      continue;
    }
    try {
      scriptWaits_ = steadySeconds() + sleepSeconds(words);
    } catch (const std::runtime_error& error) {
      script_.clear();
      return print(std::string("error: ") + error.what());
    }
  }
}

void Console::watch(const std::vector<std::string>& words, const std::string& line) {
  const std::string name = words[1];
  unwatch(name);
  const auto rest = line.find(name) + name.size();
  const std::string interval = rest < line.size() ? line.substr(rest + 1) : "";
  const int tag = session_.follow(name, interval,
                                  {[this, name](const std::string& text) {
                                     if (text.starts_with("error: ")) {
                                       print(text);
                                       return unwatch(name);
                                     }
                                     for (Watch& watch : watches_) {
                                       if (watch.name == name)
                                         watch.value = text.substr(std::min(text.size(), name.size() + 1));
                                     }
                                     changed_ = true;
                                   },
                                   {}});
  watches_.push_back({tag, name, "..."});
}

void Console::unwatch(const std::string& name) {
  for (auto at = watches_.begin(); at != watches_.end();) {
    if (!name.empty() && at->name != name) {
      ++at;
      continue;
    }
    session_.forget(at->tag);
    at = watches_.erase(at);
  }
  changed_ = true;
}

}  // namespace plumbline::rdb
