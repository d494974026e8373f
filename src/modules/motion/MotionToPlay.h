#pragma once
#include <string>

namespace plumbline {

/// Which motion the module MotionPlayer plays; main gives it to the module's objects.
struct MotionToPlay {
  std::string name;   ///< of a file in motions/, without its ending
  bool once = false;  ///< then the agent ends; otherwise again and again
};

}  // namespace plumbline
