#pragma once
#include <string>

#include "framework/PartialFolder.h"

namespace plumbline::gap {

/// A folder of recordings that is being written: made next to its place, then moved there as a whole. If it
/// is not moved, it is removed.
class RecordingsFolder {
public:
  /// replace: an existing folder is replaced at the end, if it holds only recordings. Throws
  /// std::invalid_argument for another existing folder, std::runtime_error if nothing can be written.
  RecordingsFolder(const std::string& path, bool replace);

  /// The folder to write to meanwhile; it does not exist yet.
  const std::string& partial() const { return part_.path().native(); }
  /// Throws std::runtime_error "PATH: cannot be written: REASON"; the old folder stays then.
  void putInPlace();

private:
  std::string place_;
  PartialFolder part_;
};

}  // namespace plumbline::gap
