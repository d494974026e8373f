#pragma once
#include <memory>
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
  const RepresentationLoader* loader_;
  Representation* value_;
  std::unique_ptr<RepresentationHolder> lastGood_;
  bool found_ = false;    ///< a good value: lastGood_ is no longer what was there at the start
  bool numbers_ = false;  ///< some were streamed so far; what streams none needs no copies
};

}  // namespace plumbline
