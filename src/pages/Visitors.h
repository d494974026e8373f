#pragma once
#include <cstddef>
#include <functional>
#include <vector>

struct lws;

namespace plumbline::pages {

/// The connections of a page's server in the order in which they came. With more than `most`, those that have
/// asked for nothing yet give way to newcomers: silent connections lock nobody out.
class Visitors {
public:
  explicit Visitors(std::size_t most) : most_(most) {}

  void add(lws* connection);
  /// It has asked for something, and is not sent away from now on.
  void asked(lws* connection);
  void remove(lws* connection);

  /// A connection to be closed, each named once, or null: call until it is null, when one has come or
  /// something was read. It is the one that has been silent longest, the last that came apart. `hasSent`:
  /// something has come from it that was not read yet.
  lws* toClose(const std::function<bool(lws*)>& hasSent);

private:
  struct Visitor {
    lws* connection;
    bool silent = true, leaves = false;
  };
  std::size_t most_, leaving_ = 0;
  std::vector<Visitor> visitors_;
};

}  // namespace plumbline::pages
