#include "framework/ThreadCopy.h"

namespace plumbline {

void ThreadCopy::add(const RepresentationLoader& loader, const Representation& source,
                     Representation& target) {
  Entry entry{&loader, &source, &target, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    entry.owners[i] = loader.create();
    entry.copies[i] = &entry.owners[i]->get();
  }
  entries_.push_back(std::move(entry));
}

void ThreadCopy::publish() {
  for (Entry& entry : entries_) entry.loader->copy(*entry.source, *entry.copies[writing_]);
  writing_ = middle_.exchange(writing_ | fresh, std::memory_order_acq_rel) & indexMask;
}

bool ThreadCopy::fetch() {
  // Only this side takes `fresh` away: seen once, it stays.
  if (!(middle_.load(std::memory_order_relaxed) & fresh)) return false;
  reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & indexMask;
  for (Entry& entry : entries_) entry.loader->copy(*entry.copies[reading_], *entry.target);
  return true;
}

}  // namespace plumbline
