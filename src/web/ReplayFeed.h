#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "web/Broadcast.h"
#include "web/Feed.h"
#include "web/GoalMarks.h"
#include "web/MatchFile.h"

namespace plumbline::web {

/// Shows a recorded match; pages may stop it, choose its rate and any time of it. On channel replay it tells
/// {"kind":"replay","time":,"duration":,"playing":,"rate":,"goals":[{"time":,"side":}],"problem":}.
class ReplayFeed : public Feed {
public:
  /// Throws std::runtime_error, one line, if the file cannot be read.
  ReplayFeed(const std::string& file, Broadcast& broadcast);
  ~ReplayFeed() override;

  void command(const PageCommand& command) override;
  double duration() const { return reader.duration(); }

private:
  void run();
  void seek(double time);
  void advance(double time);
  void load(std::size_t chunk);
  void publish(const MatchRecord& record);
  void publishStatus();
  /// Looks through one more chunk of the file.
  void findGoals();

  std::string name;
  Broadcast& broadcast;
  MatchReader reader;
  std::vector<MatchRecord> records;  ///< of the chunk being shown
  std::size_t chunk = 0, next = 0;
  double time = 0;
  GoalMarks marks;
  std::size_t scanned = 0;  ///< chunks that have been looked through for goals

  std::mutex mutex;
  std::condition_variable wake;
  bool stop = false, playing = true, statusChanged = true;
  double rate = 1;
  std::optional<double> wanted;  ///< time asked for
  std::string problem;
  std::thread thread;
};

}  // namespace plumbline::web
