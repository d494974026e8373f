#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "framework/InStream.h"
#include "framework/OutStream.h"

namespace plumbline {

class Drawing;

/// A value of any type as the debug interface sees it: it writes itself and may read itself.
class DebugValue {
public:
  virtual void write(OutStream& out) const = 0;
  virtual bool writable() const { return false; }
  virtual void read(InStream&) {}
  /// Behind read: "", or what must not be as it is now.
  virtual std::string problem() const { return {}; }
  /// What it draws, where it is a drawing; null otherwise. Valid as long as this.
  virtual const Drawing* drawing() const { return nullptr; }

protected:
  ~DebugValue() = default;
};

/// A request of a client at a debug point. Called on the thread that passes the point: no call may wait or
/// throw.
class DebugRequest {
public:
  virtual ~DebugRequest() = default;
  /// At a value: reads it, or changes it.
  virtual void serve(DebugValue&) noexcept {}
  /// At a block of code: true if it shall run now.
  virtual bool run() noexcept { return false; }
  /// What the block says while it runs.
  virtual void output(std::string_view) noexcept {}
  /// The block could not do what it was to do.
  virtual void failed(std::string_view) noexcept {}
  /// The block has run.
  virtual void finished() noexcept {}
};

using DebugRequests = std::vector<std::shared_ptr<DebugRequest>>;

/// output: a value to read. modify: one that may be set. parameter: one that is set once. timing: a
/// stopwatch. code, codeOnce: a block that runs on request, again and again or once. drawing: shapes to read.
enum class DebugKind : std::uint8_t { output, modify, parameter, timing, code, codeOnce, drawing };
/// "output", "modify", "parameter", "timing", "response", "response once", "drawing".
std::string_view nameOf(DebugKind kind);

/// A place in the code at which a value can be read or set, or a block of code can be switched on. Without a
/// request, passing it costs a relaxed load. Static points (DebugSite.h) register themselves when they are
/// first passed.
class DebugPoint {
public:
  constexpr DebugPoint(const char* id, DebugKind kind) : id_(id), kind_(kind) {}
  DebugPoint(const DebugPoint&) = delete;
  DebugPoint& operator=(const DebugPoint&) = delete;

  const char* id() const { return id_; }
  DebugKind kind() const { return kind_; }

  bool active() const { return state_.load(std::memory_order_relaxed) != State::off; }
  /// The rest of passing an active point.
  void pass(DebugValue& value);

  /// Holds the requests of an active point that is a block of code while the block runs.
  class Visit {
  public:
    explicit Visit(DebugPoint& point);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;
    bool run() const { return run_; }
    void output(std::string_view text) const;
    void fail(std::string_view text) const;

  private:
    DebugPoint& point_;
    const DebugRequests* requests_ = nullptr;
    bool run_ = false;
  };

private:
  friend class DebugPoints;
  enum class State : std::uint8_t { off, on, unknown };

  const DebugRequests* enter();
  void leave() { readers_.fetch_sub(1, std::memory_order_release); }

  const char* id_;
  DebugKind kind_;
  std::atomic<State> state_{State::unknown};
  std::atomic<unsigned> readers_{0};  ///< threads that look at the requests now
  std::atomic<const DebugRequests*> requests_{nullptr};
};

}  // namespace plumbline
