#pragma once
#include <string>
#include <vector>

#include "record/Schema.h"

namespace plumbline::record {

/// A representation as a log holds it.
struct RecordedTopic {
  std::string representation;
  std::string provider;  ///< who provided it: a module, a thread or a special module
  Schema schema;
};

/// What is recorded of one thread of an agent.
struct RecordedThread {
  std::string name;
  /// `Module:execute`, `Module:updateBallPos`, ... in the order of a cycle.
  std::vector<std::string> steps;
  std::vector<RecordedTopic> topics;
};

}  // namespace plumbline::record
