#include "framework/ModulesConfig.h"

#include <cctype>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/ReadFile.h"
#include "framework/SingleLine.h"

namespace plumbline {
namespace {

constexpr std::size_t maxListSize = 1 << 20, maxFiles = 100;

bool isName(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (!std::isalpha(c) && c != '_' && (i == 0 || !std::isdigit(c))) return false;
  }
  return !text.empty();
}

std::string_view trimmed(std::string_view text) {
  const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> result;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::string_view word = text.substr(0, text.find_first_of(" \t\r"));
    result.push_back(word);
    text.remove_prefix(word.size());
  }
  return result;
}

class Parser {
public:
  explicit Parser(const std::string& path) { config_.path = path; }

  ModulesConfig parse(std::string_view text) {
    parseFile(text, config_.path);
    for (const ThreadConfig& thread : config_.threads)
      if (thread.lines.empty()) failAt(thread.path, thread.line, "thread " + thread.name + " has no modules");
    if (config_.threads.empty()) throw ConfigurationError(config_.path + ": no modules");
    return std::move(config_);
  }

private:
  void parseFile(std::string_view text, const std::string& path) {
    open_.push_back({path, 0});
    while (!text.empty()) {
      open_.back().line++;
      const std::size_t end = text.find('\n');
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      line = trimmed(line.substr(0, line.find('#')));
      if (line.empty()) continue;
      if (line.front() == '[')
        section(line);
      else
        entry(line);
    }
    open_.pop_back();
  }

  void include(const std::vector<std::string_view>& parts) {
    if (parts.size() != 2) fail("include names one file: include FILE");
    namespace fs = std::filesystem;
    const std::string path =
        (fs::path(open_.back().path).parent_path() / fs::path(parts[1])).lexically_normal().string();
    for (const Place& file : open_)
      if (fs::path(file.path).lexically_normal() == path)
        fail("include " + path + ": a file cannot include itself");
    if (++files_ > maxFiles) fail("include " + path + ": more than 100 files are included");
    std::string text;
    try {
      text = readFile(path, maxListSize);
    } catch (const std::runtime_error& error) {
      fail("include " + path + ": " + error.what());
    }
    parseFile(text, path);
  }

  [[noreturn]] static void failAt(const std::string& path, int line, const std::string& message) {
    throw ConfigurationError(singleLine(path + ":" + std::to_string(line) + ": " + message));
  }
  [[noreturn]] void fail(const std::string& message) const {
    failAt(open_.back().path, open_.back().line, message);
  }
  [[noreturn]] void failForm(std::string_view line) const {
    fail(
        "expected \"Module\", \"Module Representation\", \"thread Representation\", \"include FILE\" or "
        "\"[thread priority]\", not \"" +
        std::string(line.substr(0, 60)) + "\"");
  }

  void section(std::string_view line) {
    if (line.back() != ']') failForm(line);
    const auto parts = words(line.substr(1, line.size() - 2));
    if (parts.empty() || parts.size() > 3 || !isName(parts[0])) failForm(line);
    ThreadConfig thread;
    thread.name = parts[0];
    thread.line = open_.back().line;
    thread.path = open_.back().path;
    const std::string_view priority = parts.size() >= 2 ? parts[1] : "";
    const auto [end, error] =
        std::from_chars(priority.data(), priority.data() + priority.size(), thread.priority);
    if (error != std::errc{} || end != priority.data() + priority.size() || thread.priority < 0 ||
        thread.priority > ThreadConfig::maxPriority) {
      fail("thread " + thread.name + " needs a priority from 0 to 15" +
           (priority.empty() ? "" : ", not \"" + std::string(priority) + "\""));
    }
    if (parts.size() == 3) thread.rate = rate(thread.name, parts[2]);
    for (const ThreadConfig& other : config_.threads) {
      if (other.line == 0) {
        const ModulesConfigLine& first = other.lines.front();
        failAt(first.path, first.line,
               "\"" + first.provider + "\" comes before the first [thread priority]; put it below one");
      }
      if (other.name == thread.name) {
        fail("thread " + thread.name + " is already in " +
             (other.path == thread.path ? "line " : other.path + ":") + std::to_string(other.line));
      }
    }
    config_.threads.push_back(std::move(thread));
  }

  double rate(const std::string& thread, std::string_view text) const {
    double value = 0;
    const bool hertz = text.size() > 2 && text.substr(text.size() - 2) == "Hz";
    const char* last = text.data() + text.size() - (hertz ? 2 : 0);
    const auto [end, error] = std::from_chars(text.data(), last, value);
    if (!hertz || error != std::errc{} || end != last || !(value > 0 && value <= ThreadConfig::maxRate))
      fail("thread " + thread + ": a rate is a number of Hz up to 100000, as 100Hz, not \"" +
           std::string(text.substr(0, 60)) + "\"");
    return value;
  }

  void entry(std::string_view line) {
    const auto parts = words(line);
    if (parts[0] == "include") return include(parts);
    if (parts.size() > 2 || !isName(parts[0]) || (parts.size() == 2 && !isName(parts[1]))) failForm(line);
    if (config_.threads.empty()) {
      config_.threads.emplace_back();
      config_.threads.back().name = ModulesConfig::defaultThread;
    }
    config_.threads.back().lines.push_back({open_.back().line, std::string(parts[0]),
                                            parts.size() == 2 ? std::string(parts[1]) : "",
                                            open_.back().path});
  }

  struct Place {
    std::string path;
    int line;
  };
  ModulesConfig config_;
  std::vector<Place> open_;  ///< the file that is read, and those that include it
  std::size_t files_ = 0;
};

}  // namespace

ModulesConfig parseModulesConfig(std::string_view text, const std::string& path) {
  return Parser(path).parse(text);
}

ModulesConfig readModulesConfig(const std::string& path) {
  std::string text;
  try {
    text = readFile(path, maxListSize);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(path + ": " + error.what());
  }
  return parseModulesConfig(text, path);
}

}  // namespace plumbline
