#include "Session.h"

#include <charconv>
#include <sstream>
#include <stdexcept>

namespace plumbline::rdb {

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream in(line);
  in.exceptions(std::ios::badbit);  // a lack of memory is not the end of the text
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

double sleepSeconds(const std::vector<std::string>& words) {
  constexpr double longest = 86400;
  const std::string text = words.size() == 2 ? words[1] : "";
  double seconds = -1;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size() ||
      !(seconds >= 0 && seconds <= longest))
    throw std::runtime_error("sleep SECONDS, up to 86400");
  return seconds;
}

int Session::ask(const std::string& command, Handler handler) {
  const int tag = ++tags_;
  open_[tag] = {command, std::move(handler), false};
  if (link_.connected()) link_.send('#' + std::to_string(tag) + ' ' + command);
  return tag;
}

int Session::follow(const std::string& name, const std::string& interval, Handler handler) {
  const int tag = ask("watch " + name + (interval.empty() ? "" : ' ' + interval), std::move(handler));
  open_[tag].follows = true;
  return tag;
}

void Session::forget(int tag) {
  const auto found = open_.find(tag);
  if (found == open_.end()) return;
  const std::string name = wordsOf(found->second.command).at(1);
  open_.erase(found);
  bool others = false;
  for (const auto& [number, open] : open_)
    others = others || (open.follows && wordsOf(open.command).at(1) == name);
  if (!others) ask("unwatch " + name, {});
}

void Session::receive(double seconds) {
  for (const std::string& line : link_.receive(seconds)) {
    int tag = 0;
    const auto space = line.find(' ');
    if (line[0] != '#' || space == std::string::npos ||
        std::from_chars(line.data() + 1, line.data() + space, tag).ec != std::errc{}) {
      if (other && !line.empty()) other(line);
      continue;
    }
    const auto found = open_.find(tag);
    if (found == open_.end()) continue;
    const std::string text = line.substr(space + 1);
    const Handler handler = found->second.handler;
    if (text == ".") {
      open_.erase(found);
      if (handler.ended) handler.ended(false);
    } else if (handler.line) {
      handler.line(text);
    }
  }
}

void Session::lost() {
  std::vector<Handler> ended;
  for (auto at = open_.begin(); at != open_.end();) {
    if (at->second.follows) {
      ++at;
      continue;
    }
    ended.push_back(at->second.handler);
    at = open_.erase(at);
  }
  for (const Handler& handler : ended) {
    if (handler.ended) handler.ended(true);
  }
}

void Session::resume() {
  for (const auto& [tag, open] : open_) link_.send('#' + std::to_string(tag) + ' ' + open.command);
}

std::string Session::plot(const std::vector<std::string>& words,
                          const std::function<void(const std::string&)>& failed) {
  constexpr const char* usage = "plot VALUE [WINDOW [COUNT [SECONDS]]]";
  if (words.size() < 2 || words.size() > 5) throw std::runtime_error(usage);
  const std::string& name = words[1];
  const std::string window = words.size() > 2 ? words[2] : name;
  std::size_t count = Plot::standardCount;
  if (words.size() > 3) {
    const auto read = std::from_chars(words[3].data(), words[3].data() + words[3].size(), count);
    if (read.ec != std::errc{} || read.ptr != words[3].data() + words[3].size() || count < 2 ||
        count > Plot::maxCount)
      throw std::runtime_error(std::string(usage) + ": the count is 2 to 100000, not \"" + words[3] + '"');
  }
  double interval = Plot::standardInterval;
  if (words.size() > 4) {
    const auto read = std::from_chars(words[4].data(), words[4].data() + words[4].size(), interval);
    if (read.ec != std::errc{} || read.ptr != words[4].data() + words[4].size() ||
        !(interval >= Plot::minInterval && interval <= Plot::maxInterval))
      throw std::runtime_error(std::string(usage) +
                               ": the picture is drawn every 0.02 to 3600 seconds, not \"" + words[4] + '"');
  }
  const bool known = plots_.contains(window);
  Plot& plot = plots_[window];
  if (!known || words.size() > 3) plot.setCount(count);
  if (words.size() > 4) plot.setInterval(interval);
  plot.open(name);
  const auto line = [this, name, window, failed](const std::string& text) {
    if (text.starts_with("error: ")) return failed(text.substr(7));
    const auto space = text.find(' ');
    double value = 0;
    const char *begin = text.data() + (space == std::string::npos ? 0 : space + 1),
               *end = text.data() + text.size();
    const std::string word(begin, end);
    if (word == "true" || word == "false") {
      value = word == "true" ? 1 : 0;
    } else if (const auto read = std::from_chars(begin, end, value);
               read.ec != std::errc{} || read.ptr != end) {
      failed(name + " is no number: plot a part of it, as " + name + ".x");
      return endPlots(window);
    }
    if (const auto found = plots_.find(window); found != plots_.end()) found->second.add(name, value);
  };
  plotOf_[follow(name, "", {line, {}})] = window;
  return window;
}

void Session::endPlots(const std::string& window) {
  std::vector<int> ended;
  for (const auto& [tag, of] : plotOf_) {
    if (window.empty() || of == window) ended.push_back(tag);
  }
  for (const int tag : ended) {
    forget(tag);
    plotOf_.erase(tag);
  }
  if (window.empty()) plots_.clear();
  plots_.erase(window);
}

}  // namespace plumbline::rdb
