#include "framework/OutputGuard.h"

#include <cstring>

namespace plumbline {

OutputGuard::OutputGuard(const RepresentationLoader& loader, Representation& value)
    : loader_(&loader),
      value_(&value),
      lastGood_(loader.create()),
      last_(&lastGood_->get()),
      bytes_(loader.plainBytes(value)),
      lastBytes_(loader.plainBytes(*last_)),
      hasOwnCheck_(loader.hasOwnCheck()) {
  loader.copy(value, *last_);
}

bool OutputGuard::stayed() const {
  return found_ && bytes_ && std::memcmp(bytes_->data(), lastBytes_->data(), bytes_->size()) == 0;
}

std::string OutputGuard::check() {
  if (stayed()) return {};
  std::string problem;
  if (!streamsFiniteNumbers(*value_, numbers_))
    problem = numberProblem(*value_);
  else if (hasOwnCheck_)
    problem = loader_->ownProblem(*value_);
  if (!problem.empty()) {
    loader_->copy(*last_, *value_);
  } else if (numbers_ || hasOwnCheck_) {
    loader_->copy(*value_, *last_);
    found_ = true;
  }
  return problem;
}

}  // namespace plumbline
