#include "inspect/Outbox.h"

#include <algorithm>
#include <new>

namespace plumbline::inspect {

std::size_t Outcome::size() const { return text.size() + (drawing ? drawing->size() : 0); }

bool Outbox::push(Outcome outcome) noexcept {
  if (count_.load(std::memory_order_relaxed) >= most || bytes_.load(std::memory_order_relaxed) >= mostBytes)
    return false;
  const std::size_t size = outcome.size();
  Node* node = new (std::nothrow) Node{std::move(outcome), nullptr};
  if (!node) return false;
  count_.fetch_add(1, std::memory_order_relaxed);
  bytes_.fetch_add(size, std::memory_order_relaxed);
  node->next = newest_.load(std::memory_order_relaxed);
  while (!newest_.compare_exchange_weak(node->next, node, std::memory_order_release)) {
  }
  return true;
}

std::vector<Outcome> Outbox::take() {
  std::vector<Outcome> outcomes;
  for (Node* node = newest_.exchange(nullptr, std::memory_order_acquire); node;) {
    const std::unique_ptr<Node> owner(node);
    count_.fetch_sub(1, std::memory_order_relaxed);
    bytes_.fetch_sub(node->outcome.size(), std::memory_order_relaxed);
    outcomes.push_back(std::move(node->outcome));
    node = node->next;
  }
  std::ranges::reverse(outcomes);
  return outcomes;
}

}  // namespace plumbline::inspect
