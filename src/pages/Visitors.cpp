#include "pages/Visitors.h"

#include <algorithm>

namespace plumbline::pages {

void Visitors::add(lws* connection) { visitors_.push_back({connection}); }

void Visitors::asked(lws* connection) {
  const auto found = std::ranges::find(visitors_, connection, &Visitor::connection);
  if (found != visitors_.end()) found->silent = false;
}

void Visitors::remove(lws* connection) {
  const auto found = std::ranges::find(visitors_, connection, &Visitor::connection);
  if (found == visitors_.end()) return;
  if (found->leaves) --leaving_;
  visitors_.erase(found);
}

lws* Visitors::toClose(const std::function<bool(lws*)>& hasSent) {
  if (visitors_.size() - leaving_ <= most_) return nullptr;
  for (Visitor& visitor : visitors_) {
    if (&visitor == &visitors_.back() || !visitor.silent || visitor.leaves) continue;
    if (hasSent(visitor.connection)) continue;
    visitor.leaves = true;
    ++leaving_;
    return visitor.connection;
  }
  return nullptr;
}

}  // namespace plumbline::pages
