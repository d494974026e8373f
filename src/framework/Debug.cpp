#include "framework/Debug.h"

namespace plumbline {

Debug::Measurement Debug::stopwatch(const std::string& name) {
  auto& stopwatch = stopwatches_[name];
  if (!stopwatch) stopwatch = std::make_shared<Stopwatch>();
  return Measurement(*stopwatch);
}

}  // namespace plumbline
