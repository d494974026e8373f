#include "framework/ModulesConfig.h"

#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

constexpr std::size_t maxFileSize = 1 << 20;

bool isName(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); i++) {
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
    while (!text.empty()) {
      line_++;
      const std::size_t end = text.find('\n');
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      line = trimmed(line.substr(0, line.find('#')));
      if (line.empty()) continue;
      line.front() == '[' ? section(line) : entry(line);
    }
    for (const ThreadConfig& thread : config_.threads) {
      line_ = thread.line;
      if (thread.lines.empty()) fail("thread " + thread.name + " has no modules");
    }
    if (config_.threads.empty()) throw ConfigurationError(config_.path + ": no modules");
    return std::move(config_);
  }

private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ConfigurationError(config_.path + ":" + std::to_string(line_) + ": " + message);
  }
  [[noreturn]] void failForm(std::string_view line) const {
    fail(
        "expected \"Module\", \"Module Representation\", \"thread Representation\" or \"[thread priority]\", "
        "not \"" +
        std::string(line.substr(0, 60)) + "\"");
  }

  void section(std::string_view line) {
    if (line.back() != ']') failForm(line);
    const auto parts = words(line.substr(1, line.size() - 2));
    if (parts.empty() || parts.size() > 2 || !isName(parts[0])) failForm(line);
    ThreadConfig thread;
    thread.name = parts[0];
    thread.line = line_;
    const std::string_view priority = parts.size() == 2 ? parts[1] : "";
    const auto [end, error] =
        std::from_chars(priority.data(), priority.data() + priority.size(), thread.priority);
    if (error != std::errc{} || end != priority.data() + priority.size() || thread.priority < 0 ||
        thread.priority > ThreadConfig::maxPriority) {
      fail("thread " + thread.name + " needs a priority from 0 to 15" +
           (priority.empty() ? "" : ", not \"" + std::string(priority) + "\""));
    }
    for (const ThreadConfig& other : config_.threads) {
      if (other.line == 0) {
        line_ = other.lines.front().line;
        fail("\"" + other.lines.front().provider +
             "\" stands before the first [thread priority]; put it below one");
      }
      if (other.name == thread.name) {
        fail("thread " + thread.name + " is already in line " + std::to_string(other.line));
      }
    }
    config_.threads.push_back(std::move(thread));
  }

  void entry(std::string_view line) {
    const auto parts = words(line);
    if (parts.size() > 2 || !isName(parts[0]) || (parts.size() == 2 && !isName(parts[1]))) failForm(line);
    if (config_.threads.empty()) {
      config_.threads.emplace_back();
      config_.threads.back().name = ModulesConfig::defaultThread;
    }
    config_.threads.back().lines.push_back(
        {line_, std::string(parts[0]), parts.size() == 2 ? std::string(parts[1]) : ""});
  }

  ModulesConfig config_;
  int line_ = 0;
};

}  // namespace

ModulesConfig parseModulesConfig(std::string_view text, const std::string& path) {
  return Parser(path).parse(text);
}

ModulesConfig readModulesConfig(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw ConfigurationError(path + ": cannot be read: " + std::strerror(errno));
  std::string text(maxFileSize + 1, '\0');
  errno = 0;
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad())
    throw ConfigurationError(path + ": cannot be read: " + std::strerror(errno ? errno : EISDIR));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > maxFileSize) throw ConfigurationError(path + ": larger than 1 MB");
  return parseModulesConfig(text, path);
}

}  // namespace plumbline
