#pragma once
#include "web/PageCommand.h"

namespace plumbline::web {

/// Where the pages' scene comes from; it publishes to a Broadcast from a thread of its own until it is
/// destroyed.
class Feed {
public:
  virtual ~Feed() = default;
  /// Asks for something; what the source cannot do is ignored. Safe between threads.
  virtual void command(const PageCommand& command) = 0;
};

}  // namespace plumbline::web
