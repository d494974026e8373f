#pragma once
#include <string>
#include <vector>

#include "Session.h"
#include "framework/StopSignal.h"

namespace plumbline::rdb {

/// Runs commands one after the other and prints the answers: for shells.
class Batch {
public:
  struct Options {
    double seconds = 0;  ///< a watch ends after so long; 0: only by a signal
    std::string png;     ///< where plots are drawn; empty: as text
  };

  Batch(Link& link, Session& session, const StopSignal& stop, Options options);
  /// `place` precedes an error: "FILE:3: ", or nothing. A watch goes on beside what follows. Throws
  /// std::runtime_error for an error of the agent.
  void run(const std::string& line, const std::string& place);
  /// Prints what watches say, until the end of Options; at once if nothing is watched.
  void follow();
  /// A file of commands; lines that begin with # are comments. False: stopped within it.
  bool runFile(const std::string& path);
  /// Waits until all plots are full and shows them.
  void showPlots();

private:
  void receiveFor(double seconds);
  void receive(double seconds);

  Link& link_;
  Session& session_;
  const StopSignal& stop_;
  Options options_;
  std::string error_;
  int lasting_ = 0;  ///< watches, and blocks of code that may still have something to say
};

}  // namespace plumbline::rdb
