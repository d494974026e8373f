#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "framework/CrashRecord.h"

namespace plumbline {

/// Takes all messages of the process: keeps the last ones in a ring for crash.log, prints them with -v.
class LogBuffer {
public:
  static LogBuffer& instance();

  /// One message; safe from any thread.
  void add(std::string_view source, std::string_view message);
  /// One line of the -v trace (`[thread] Module:execute`); not kept in the ring.
  void trace(std::string_view line);

  /// Prints messages and trace to standard output (the option -v).
  void setVerbose(bool verbose);
  bool verbose() const { return verbose_; }

  /// Also hands every message to this function (tests, other log targets); called under a lock.
  void setListener(std::function<void(std::string_view source, std::string_view message)> listener);

  /// Moves the ring to memory another process can read. Before any other thread logs.
  void useRecord(CrashRecord* record);
  CrashRecord& record() { return *record_; }

private:
  LogBuffer();
  std::unique_ptr<CrashRecord> own_;
  CrashRecord* record_;
  bool verbose_ = false;
};

}  // namespace plumbline
