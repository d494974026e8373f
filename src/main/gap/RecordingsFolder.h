#pragma once
#include <string>

#include "framework/PartialFolder.h"

namespace plumbline::gap {

/// A folder of recordings that is being written: made next to its place, then moved there as a whole. If it
/// is not moved, it is removed.
class RecordingsFolder {
public:
  /// replace: an existing folder is replaced at the end, if it holds only recordings. Throws
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
