#include "record/LogWalk.h"

namespace plumbline::record {

LogWalk::LogWalk(LogReader& log) : log_(log), at_(log.threads().size(), 0) {
  for (const LogReader::Thread& thread : log.threads()) {
    messages_.emplace_back(thread.recorded.topics.size());
    total_ += thread.cycles.size();
  }
}

bool LogWalk::next(Step& step) {
  const auto& threads = log_.threads();
  std::size_t best = threads.size();
  const LogReader::Cycle* first = nullptr;
  for (std::size_t t = 0; t < threads.size(); ++t) {
    if (at_[t] >= threads[t].cycles.size()) continue;
    const LogReader::Cycle& cycle = threads[t].cycles[at_[t]];
    if (first && std::pair(first->file, first->first) <= std::pair(cycle.file, cycle.first)) continue;
    best = t;
    first = &cycle;
  }
  if (!first) return false;
  at_[best]++;
  done_++;
  changed_.clear();
  log_.read(threads[best], *first, [&](std::size_t topic, std::string_view message) {
    messages_[best][topic].assign(message);
    changed_.push_back(topic);
  });
  step = {best, first, &messages_[best], &changed_};
  return true;
}

}  // namespace plumbline::record
