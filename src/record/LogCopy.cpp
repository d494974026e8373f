#include "record/LogCopy.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "framework/NearestName.h"
#include "framework/StopSignal.h"
#include "record/LogWalk.h"
#include "record/LogWriter.h"

namespace plumbline::record {
namespace {

constexpr std::size_t stride = 256;                ///< cycles between two words of progress
constexpr std::int64_t pauseBetween = 20'000'000;  ///< of two recordings [ns]

/// Removes a log that is half written.
class Target {
public:
  explicit Target(const std::string& folder)
      : writer_(std::make_unique<LogWriter>(folder, LogWriterOptions{})) {}
  ~Target() {
    if (!writer_) return;
    const std::string folder = writer_->folder();
    writer_.reset();
    std::error_code error;
    std::filesystem::remove_all(folder, error);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  LogWriter& operator*() { return *writer_; }
  LogWriter* operator->() { return writer_.get(); }
  void finish() {
    writer_->finish();
    writer_.reset();
  }

private:
  std::unique_ptr<LogWriter> writer_;
};

/// The threads with only these topics, and for each where its topics are in the whole.
std::vector<RecordedThread> chosen(const LogReader& log, const std::vector<std::string>& only,
                                   std::vector<std::vector<std::size_t>>& topics) {
  std::vector<std::string> names;
  std::vector<RecordedThread> threads;
  for (const LogReader::Thread& thread : log.threads()) {
    threads.push_back({thread.recorded.name, thread.recorded.steps, {}});
    topics.emplace_back();
    for (std::size_t i = 0; i < thread.recorded.topics.size(); ++i) {
      const RecordedTopic& topic = thread.recorded.topics[i];
      names.push_back(topic.representation);
      if (!only.empty() && std::ranges::find(only, topic.representation) == only.end()) continue;
      threads.back().topics.push_back(topic);
      topics.back().push_back(i);
    }
  }
  for (const std::string& name : only)
    if (std::ranges::find(names, name) == names.end())
      throw std::runtime_error(log.path() + " has no " + name + suggestion(name, names));
  return threads;
}

bool within(const LogPart& part, const LogReader::Cycle& cycle) {
  const double time = secondsOf(cycle.timestamp);
  return time >= part.from && time <= part.to && cycle.number >= part.firstCycle &&
         cycle.number <= part.lastCycle;
}

void sameThreads(const LogReader& first, const LogReader& other) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(other.path() + " cannot be appended to " + first.path() + ": " + what);
  };
  if (first.threads().size() != other.threads().size()) fail("it has other threads");
  for (std::size_t t = 0; t < first.threads().size(); ++t) {
    const RecordedThread &a = first.threads()[t].recorded, &b = other.threads()[t].recorded;
    if (a.name != b.name) fail("it has other threads");
    for (const RecordedTopic& topic : a.topics) {
      const auto same = std::ranges::find(b.topics, topic.representation, &RecordedTopic::representation);
      if (same == b.topics.end()) fail("it has no " + topic.representation);
      if (same->schema != topic.schema) fail(topic.representation + " has other members");
    }
    if (a.topics.size() != b.topics.size()) fail("it has more representations");
  }
}

}  // namespace

std::uint64_t cutLog(const std::string& path, const std::string& target, const LogPart& part,
                     const Progress& progress) {
  LogReader log(path);
  std::vector<std::vector<std::size_t>> topics;
  std::vector<RecordedThread> threads = chosen(log, part.only, topics);
  Target out(target);
  out->begin(std::move(threads));
  LogWalk walk(log);
  LogWalk::Step step{};
  CycleView view;
  while (walk.next(step)) {
    StopSignal::throwIfCaught();
    if (progress && walk.done() % stride == 0)
      progress(static_cast<double>(walk.done()) / static_cast<double>(walk.total()));
    if (!within(part, *step.cycle)) continue;
    view.thread = step.thread;
    view.number = step.cycle->number;
    view.timestamp = step.cycle->timestamp;
    view.messages.clear();
    for (const std::size_t topic : topics[step.thread]) view.messages.emplace_back((*step.messages)[topic]);
    out->write(view);
  }
  const std::uint64_t cycles = out->cycles();
  if (cycles == 0) throw std::runtime_error(path + " has no cycle in that part");
  out.finish();
  return cycles;
}

std::uint64_t joinLogs(const std::vector<std::string>& paths, const std::string& target,
                       const Progress& progress) {
  if (paths.empty()) throw std::runtime_error("no log to join");
  std::vector<std::unique_ptr<LogReader>> logs;
  for (const std::string& path : paths) {
    logs.push_back(std::make_unique<LogReader>(path));
    sameThreads(*logs.front(), *logs.back());
  }
  std::vector<RecordedThread> threads;
  for (const LogReader::Thread& thread : logs.front()->threads()) threads.push_back(thread.recorded);
  Target out(target);
  out->begin(threads);
  std::vector<std::uint64_t> last(threads.size(), 0);  // number of each thread's
  std::int64_t lastTime = 0;
  CycleView view;
  for (std::size_t l = 0; l < logs.size(); ++l) {
    LogReader& log = *logs[l];
    std::vector<std::uint64_t> shift(threads.size(), 0);
    std::int64_t firstTime = std::numeric_limits<std::int64_t>::max();
    for (std::size_t t = 0; t < threads.size(); ++t) {
      const auto& cycles = log.threads()[t].cycles;
      if (cycles.empty()) continue;
      firstTime = std::min(firstTime, cycles.front().timestamp);
      // One number stays free: the cycles do not follow each other.
      if (cycles.front().number <= last[t]) shift[t] = last[t] + 2 - cycles.front().number;
    }
    const std::int64_t timeShift = l > 0 && firstTime <= lastTime ? lastTime + pauseBetween - firstTime : 0;
    LogWalk walk(log);
    LogWalk::Step step{};
    while (walk.next(step)) {
      StopSignal::throwIfCaught();
      if (progress && walk.done() % stride == 0)
        progress(
            (static_cast<double>(l) + static_cast<double>(walk.done()) / static_cast<double>(walk.total())) /
            static_cast<double>(logs.size()));
      view.thread = step.thread;
      view.number = step.cycle->number + shift[step.thread];
      view.timestamp = step.cycle->timestamp + timeShift;
      view.messages.clear();
      const auto& here = log.threads()[step.thread].recorded.topics;
      for (const RecordedTopic& topic : threads[step.thread].topics) {
        const auto at = std::ranges::find(here, topic.representation, &RecordedTopic::representation);
        view.messages.emplace_back((*step.messages)[static_cast<std::size_t>(at - here.begin())]);
      }
      out->write(view);
      last[step.thread] = view.number;
      lastTime = std::max(lastTime, view.timestamp);
    }
  }
  const std::uint64_t cycles = out->cycles();
  out.finish();
  return cycles;
}

}  // namespace plumbline::record
