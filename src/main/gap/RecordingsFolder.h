#pragma once
#include <string>

#include "framework/PartialFolder.h"

namespace plumbline::gap {

/// A folder of recordings in the making: written beside its place, put there as a whole. What is not put
/// there goes.
class RecordingsFolder {
public:
  /// replace: what is there already gives way at the end, if it holds recordings and nothing else. Throws
  /// std::invalid_argument where it is there, else, and std::runtime_error where nothing can be written.
  RecordingsFolder(const std::string& path, bool replace);

  /// Where to write meanwhile; not there yet.
  const std::string& beside() const { return part_.path().native(); }
  /// Throws std::runtime_error "PATH: cannot be written: REASON"; what was there stays then.
  void putInPlace();

private:
  std::string place_;
  PartialFolder part_;
};

}  // namespace plumbline::gap
