#include "situation/CycleOfLog.h"

#include <algorithm>

namespace plumbline {

using record::LogReader;

CycleOfLog::CycleOfLog(LogReader& log, const LogReader::Thread& thread, double time)
    : log_(log), thread_(thread) {
  if (thread.cycles.empty()) throw std::runtime_error(log.path() + ": it has no cycle");
  const auto timeOf = [](const LogReader::Cycle& cycle) { return record::secondsOf(cycle.timestamp); };
  const auto behind = std::ranges::upper_bound(thread.cycles, time, {}, timeOf);
  // A tenth of a second behind the last cycle is no time at which it went on.
  if (behind == thread.cycles.begin() || time > timeOf(thread.cycles.back()) + 0.1)
    throw std::runtime_error(fmt::format("{}: its times are {:.2f} to {:.2f} s, not {:g}", log.path(),
                                         timeOf(thread.cycles.front()), timeOf(thread.cycles.back()), time));
  const auto cycle = behind - 1;
  time_ = timeOf(*cycle);
  log.readWhole(thread, static_cast<std::size_t>(cycle - thread.cycles.begin()), messages_);
}

const std::string& CycleOfLog::messageOf(const RepresentationLoader& loader) const {
  const auto& topics = thread_.recorded.topics;
  const auto topic = std::ranges::find(topics, loader.name(), &record::RecordedTopic::representation);
  if (topic == topics.end()) throw std::runtime_error(log_.path() + " has no " + loader.name());
  if (topic->schema != record::schemaOf(loader))
    throw std::runtime_error(log_.path() + ": " + loader.name() + " had other members when it was recorded");
  return messages_[static_cast<std::size_t>(topic - topics.begin())];
}

}  // namespace plumbline
