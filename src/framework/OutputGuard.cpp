#include "framework/OutputGuard.h"

namespace plumbline {

OutputGuard::OutputGuard(const RepresentationLoader& loader, Representation& value)
    : loader_(&loader), value_(&value), lastGood_(loader.create()) {
  loader.copy(value, lastGood_->get());
}

std::string OutputGuard::check() {
  if (found_ && loader_->sameBytes(*value_, lastGood_->get())) return {};
  std::string problem;
  if (!streamsFiniteNumbers(*value_, numbers_))
    problem = numberProblem(*value_);
  else
    problem = loader_->ownProblem(*value_);
  if (!problem.empty()) {
    loader_->copy(lastGood_->get(), *value_);
  } else if (numbers_ || loader_->hasOwnCheck()) {
    loader_->copy(*value_, lastGood_->get());
    found_ = true;
  }
  return problem;
}

}  // namespace plumbline
