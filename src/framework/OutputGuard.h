#pragma once
#include <memory>

#include "framework/RepresentationLoader.h"

namespace plumbline {

/// True if every floating point number that the representation streams is finite; `numbers` becomes true if
/// it streams any. One without a stream method has no fields to look at and is taken as finite.
bool streamsFiniteNumbers(Representation& value, bool& numbers);

/// Watches one representation behind its module's update: a value with a number that is not finite never
/// reaches another module. Costs a pass over the streamed numbers and a copy of the value.
class OutputGuard {
public:
  /// Both must live as long as this. Until the first good value the last good one is that of now.
  OutputGuard(const RepresentationLoader& loader, Representation& value);

  /// After an update. False: the value was not finite and is the last good one again.
  bool accept();

private:
  const RepresentationLoader* loader_;
  Representation* value_;
  std::unique_ptr<RepresentationHolder> lastGood_;
  bool numbers_ = false;  ///< some were streamed so far; what streams none needs no copies
};

}  // namespace plumbline
