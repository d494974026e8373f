#include "gap/inference/StoredParts.h"

namespace plumbline::gap {

namespace {

Scored withCausesAlone(Scored set) {
  set.fitted = {std::move(set.fitted.causes), 0, {}, {}};
  return set;
}

}  // namespace

BeamResult StoredParts::search(const std::string& name, std::size_t groups,
                               const std::function<BeamResult()>& run) {
  if (memory_)
    if (const StoredSearch* known = memory_->search(name, groups)) {
      stored_ += known->replays;
      return known->found;
    }
  const std::size_t before = asked_();
  StoredSearch done{run(), 0};
  done.replays = asked_() - before;
  for (std::vector<Scored>* sets : {&done.found.sets, &done.found.lessOne})
    for (Scored& set : *sets) set = withCausesAlone(std::move(set));
  if (memory_) memory_->keep(name, done);
  return std::move(done.found);
}

Explanation StoredParts::values(const std::string& name, const std::function<Explanation()>& run) {
  if (memory_)
    if (const StoredValues* known = memory_->values(name)) {
      stored_ += known->replays;
      return known->causes;
    }
  const std::size_t before = asked_();
  StoredValues done{run(), 0};
  done.replays = asked_() - before;
  if (memory_) memory_->keep(name, done);
  return std::move(done.causes);
}

void StoredParts::uncounted(const std::function<void()>& run) {
  const std::size_t before = asked_();
  run();
  uncounted_ += asked_() - before;
}

}  // namespace plumbline::gap
