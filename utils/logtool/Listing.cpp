#include "Listing.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/StopSignal.h"
#include "record/LogWalk.h"

namespace plumbline::logtool {

std::string listing(record::LogReader& log) {
  struct Sum {
    std::uint64_t messages = 0, bytes = 0;
  };
  std::vector<std::vector<Sum>> sums;
  for (const auto& thread : log.threads()) sums.emplace_back(thread.recorded.topics.size());
  record::LogWalk walk(log);
  record::LogWalk::Step step{};
  while (walk.next(step)) {
    StopSignal::throwIfCaught();
    for (const std::size_t topic : *step.changed) {
      sums[step.thread][topic].messages++;
      sums[step.thread][topic].bytes += (*step.messages)[topic].size();
    }
  }
  std::string text =
      fmt::format("{}: {} file{}\n", log.path(), log.files().size(), log.files().size() == 1 ? "" : "s");
  for (std::size_t t = 0; t < sums.size(); ++t) {
    const auto& thread = log.threads()[t];
    text += fmt::format("\nthread {}: {} cycles", thread.recorded.name, thread.cycles.size());
    if (!thread.cycles.empty()) {
      const auto seconds = [](std::int64_t timestamp) { return record::secondsOf(timestamp); };
      text += fmt::format(", numbers {} to {}, time {:.2f} to {:.2f} s", thread.cycles.front().number,
                          thread.cycles.back().number, seconds(thread.cycles.front().timestamp),
                          seconds(thread.cycles.back().timestamp));
    }
    if (const std::uint64_t missing = thread.missing(); missing > 0)
      text += fmt::format(", {} missing", missing);
    std::size_t width = 14, provider = 8;
    for (const record::RecordedTopic& topic : thread.recorded.topics) {
      width = std::max(width, topic.representation.size());
      provider = std::max(provider, topic.provider.size());
    }
    text += fmt::format("\n  {:{}}  {:{}}  {:>8}  {:>10}\n", "representation", width, "provider", provider,
                        "messages", "bytes");
    for (std::size_t i = 0; i < thread.recorded.topics.size(); ++i) {
      const record::RecordedTopic& topic = thread.recorded.topics[i];
      text += fmt::format("  {:{}}  {:{}}  {:>8}  {:>10}\n", topic.representation, width, topic.provider,
                          provider, sums[t][i].messages, sums[t][i].bytes);
    }
  }
  if (log.dropped() > 0)
    text += fmt::format("\n{} cycles were dropped while it was written\n", log.dropped());
  return text;
}

}  // namespace plumbline::logtool
