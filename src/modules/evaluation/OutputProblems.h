#pragma once
#include <atomic>
#include <functional>
#include <string>

namespace plumbline {

/// What modules could not write, of which an agent does not end: each says it here, and main, whose object it
/// is, ends with another status for it. An agent whose main gives none has one that prints on standard error.
class OutputProblems {
public:
  /// Takes a line for the user.
  using Notify = std::function<void(const std::string&)>;

  OutputProblems();
  explicit OutputProblems(Notify notify) : notify_(std::move(notify)) {}

  /// From any thread.
  void add(const std::string& problem);
  bool any() const { return any_; }

private:
  Notify notify_;
  std::atomic<bool> any_ = false;
};

}  // namespace plumbline
