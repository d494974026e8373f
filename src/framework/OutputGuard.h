#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "framework/RepresentationLoader.h"
#include "framework/RepresentationProblem.h"

namespace plumbline {

/// Watches one representation after its module's update: a value that is wrong
/// (RepresentationLoader::problemOf) never reaches another module. Costs a pass over the streamed numbers and
/// a copy of the value, or a comparison where it stayed as it was.
class OutputGuard {
public:
  /// Both must live as long as this. Until the first good value the last good one is that of now.
  OutputGuard(const RepresentationLoader& loader, Representation& value);

  /// After an update: "", or what was wrong with the value, which is the last good one again.
  std::string check();

private:
  bool stayed() const;

  const RepresentationLoader* loader_;
  Representation* value_;
  std::unique_ptr<RepresentationHolder> lastGood_;
  // Of the loader and the holder, which no cycle has in the processor's cache.
  Representation* last_;
  std::optional<std::span<const char>> bytes_, lastBytes_;  ///< of the value and of the last good one
  bool hasOwnCheck_;
  bool found_ = false;    ///< a good value: lastGood_ is no longer what was there at the start
  bool numbers_ = false;  ///< some were streamed so far; what streams none needs no copies
};

}  // namespace plumbline
