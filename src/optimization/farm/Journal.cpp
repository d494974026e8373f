#include "optimization/farm/Journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/FileLines.h"
#include "framework/Json.h"

namespace plumbline::farm {
namespace {

using nlohmann::json;

/// Enough to see; the exact ones follow from the results before.
double rounded(double value) { return std::stod(fmt::format("{:.7g}", value)); }

JournalEntry entryOf(const json& line) {
  JournalEntry entry;
  entry.number = line.at("trial").get<std::int64_t>();
  const json& costs = line.at("costs");
  entry.givenUp = costs.is_null();
  if (entry.givenUp) return entry;
  for (const json& cost : costs) entry.costs.push_back(cost.is_null() ? std::nan("") : cost.get<double>());
  return entry;
}

}  // namespace

Journal::Journal(std::string path, const std::string& mark,
                 const std::function<void(const JournalEntry&)>& entry)
    : path_(std::move(path)) {
  fd_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (fd_ < 0) throw std::runtime_error("cannot open " + path_ + ": " + std::strerror(errno));
  try {
    if (::flock(fd_, LOCK_EX | LOCK_NB) != 0)
      throw std::runtime_error(path_ + ": another server writes it; end that one or take another folder");
    read(mark, entry);
  } catch (...) {
    ::close(fd_);
    throw;
  }
}

Journal::~Journal() {
  ::fdatasync(fd_);
  ::close(fd_);
}

void Journal::read(const std::string& mark, const std::function<void(const JournalEntry&)>& entry) {
  std::streamoff good = 0;
  bool begun = false;
  // What is not read is cut off below: only a line without its end may be.
  FileLines lines(path_);
  std::string line;
  for (long number = 1; lines.next(line) && lines.whole(); ++number) {
    const std::string where = path_ + ':' + std::to_string(number) + ": ";
    try {
      const json value = parseJson(line, JsonLimits{.depth = 4, .bytes = maxLine});
      if (!begun && value.at("search").get<std::string>() != mark)
        throw std::runtime_error(where +
                                 "the results of another search (its options, task or program differ); "
                                 "take another folder or remove this one");
      if (begun) {
        entry(entryOf(value));
        ++resumed_;
      }
    } catch (const JsonError& error) {
      throw std::runtime_error(where + error.what() +
                               "; remove the line and all below it to continue from there");
    } catch (const json::exception&) {
      throw std::runtime_error(where + "no result; remove the line and all below it to continue from there");
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(where + error.what() +
                               "; remove the line and all below it to continue from there");
    }
    begun = true;
    good = lines.end();
  }
  if (::ftruncate(fd_, good) != 0)
    throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
  if (!begun) write(json{{"search", mark}}.dump());
}

void Journal::write(const std::string& line) {
  const std::string text = line + '\n';
  // At once, so that a kill between two writes cuts no line in two.
  const ssize_t written = ::write(fd_, text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size()))
    throw std::runtime_error("cannot write " + path_ + ": " +
                             (written < 0 ? std::strerror(errno) : "the disk is full"));
}

void Journal::add(const Trial& trial, std::span<const double> costs,
                  const std::map<std::string, double>& figures, const std::string& worker, double seconds) {
  json line{{"trial", trial.number}, {"generation", trial.generation}, {"costs", nullptr}};
  if (!costs.empty()) {
    line["costs"] = json::array();
    for (const double cost : costs) line["costs"].push_back(std::isfinite(cost) ? json(cost) : json(nullptr));
  }
  for (const auto& [name, value] : figures) line["figures"][name] = rounded(value);
  line["worker"] = worker;
  line["seconds"] = rounded(seconds);
  for (const double value : trial.parameters) line["parameters"].push_back(rounded(value));
  write(line.dump());
}

void Journal::sync() { ::fdatasync(fd_); }

}  // namespace plumbline::farm
