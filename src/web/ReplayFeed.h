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
  double duration() const { return reader_.duration(); }

private:
  void run();
  void seek(double time);
  void advance(double time);
  void load(std::size_t chunk);
  void publish(const MatchRecord& record);
  void publishStatus();
  /// Looks through one more chunk of the file.
  void findGoals();

  std::string name_;
  Broadcast& broadcast_;
  MatchReader reader_;
  std::vector<MatchRecord> records_;  ///< of the chunk being shown
  std::size_t chunk_ = 0, next_ = 0;
  double time_ = 0;
  GoalMarks marks_;
  std::size_t scanned_ = 0;  ///< chunks that have been looked through for goals

  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false, playing_ = true, statusChanged_ = true;
  double rate_ = 1;
  std::optional<double> wanted_;  ///< time asked for
  std::string problem_;
  std::thread thread_;
};

}  // namespace plumbline::web
