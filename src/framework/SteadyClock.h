#pragma once
#include <chrono>

namespace plumbline {

/// A clock that only goes on, from an unknown begin [s]. All processes of a machine share it. It may decide
/// when something is reported or given up, never what a robot does.
inline double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace plumbline
