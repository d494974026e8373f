#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "framework/DebugPoint.h"
#include "inspect/Outbox.h"
#include "inspect/Tree.h"

namespace plumbline::inspect {

/// How often a value is sent: every N passages of its point, or every N seconds; 0: not by that.
struct Interval {
  std::uint64_t cycles = 1;
  double seconds = 0;
};

/// Says whether this time has passed; from any thread.
class Pace {
public:
  explicit Pace(double seconds) : seconds_(seconds) {}
  bool due();

private:
  double seconds_;
  std::atomic<std::int64_t> next_{0};  ///< of a steady clock [ns]
};

/// A value's text form, once or again and again.
class ReadRequest final : public DebugRequest {
public:
  ReadRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once, Interval interval);
  void serve(DebugValue& value) noexcept override;
  /// Nothing is read for this time [s]; any thread.
  void pause(double seconds);

private:
  bool due();

  std::uint64_t number_;
  std::shared_ptr<Outbox> outbox_;
  bool once_;
  Interval interval_;
  std::atomic<bool> ended_{false};
  std::atomic<std::uint64_t> passages_{0};
  std::atomic<std::int64_t> pausesUntil_{0};  ///< of a steady clock [ns]; 0: it does not
  Pace pace_;
};

/// Overwrites a value or a part of it, once or at each passage. Says `done` after the first time, with the
/// value that was there before, `error` if it cannot; then the value is as it was, and it is not tried again.
class SetRequest final : public DebugRequest {
public:
  SetRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once, std::string path, Tree wanted);
  void serve(DebugValue& value) noexcept override;

private:
  std::string apply(DebugValue& value, std::string& was);

  std::uint64_t number_;
  std::shared_ptr<Outbox> outbox_;
  bool once_;
  std::string path_;
  Tree wanted_;
  std::atomic<bool> ended_{false}, answered_{false};
};

/// Takes the output of a drawing, once or each `seconds`; `done` after the first time.
class DrawRequest final : public DebugRequest {
public:
  static constexpr double seconds = 0.04;  ///< as often as viewers look
  DrawRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once);
  void serve(DebugValue& value) noexcept override;

private:
  std::uint64_t number_;
  std::shared_ptr<Outbox> outbox_;
  bool once_;
  Pace pace_{seconds};
  std::atomic<bool> ended_{false}, answered_{false};
};

/// Runs a block of code, once or at each passage. Its output are values; `done` after the first time.
class RunRequest final : public DebugRequest {
public:
  RunRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once);
  bool run() noexcept override;
  void output(std::string_view text) noexcept override;
  void failed(std::string_view text) noexcept override;
  void finished() noexcept override;

private:
  std::uint64_t number_;
  std::shared_ptr<Outbox> outbox_;
  bool once_;
  std::atomic<bool> ended_{false}, answered_{false};
};

}  // namespace plumbline::inspect
