#include "framework/DebugPoint.h"

#include "framework/DebugPoints.h"

namespace plumbline {

std::string_view nameOf(DebugKind kind) {
  switch (kind) {
    case DebugKind::output:
      return "output";
    case DebugKind::modify:
      return "modify";
    case DebugKind::parameter:
      return "parameter";
    case DebugKind::timing:
      return "timing";
    case DebugKind::code:
      return "response";
    case DebugKind::codeOnce:
      return "response once";
    case DebugKind::drawing:
      return "drawing";
  }
  return "";
}

const DebugRequests* DebugPoint::enter() {
  if (state_.load(std::memory_order_relaxed) == State::unknown) DebugPoints::sites().tryAdd(*this);
  // Both in the one order of all threads: who swaps the requests and then sees no reader may free the old.
  readers_.fetch_add(1, std::memory_order_seq_cst);
  return requests_.load(std::memory_order_seq_cst);
}

void DebugPoint::pass(DebugValue& value) {
  if (const DebugRequests* requests = enter()) {
    for (const auto& request : *requests) request->serve(value);
  }
  leave();
}

DebugPoint::Visit::Visit(DebugPoint& point) : point_(point), requests_(point.enter()) {
  if (!requests_) return;
  for (const auto& request : *requests_) run_ = request->run() || run_;
}

DebugPoint::Visit::~Visit() {
  if (run_) {
    for (const auto& request : *requests_) request->finished();
  }
  point_.leave();
}

void DebugPoint::Visit::output(std::string_view text) const {
  if (!requests_) return;
  for (const auto& request : *requests_) request->output(text);
}

void DebugPoint::Visit::fail(std::string_view text) const {
  if (!requests_) return;
  for (const auto& request : *requests_) request->failed(text);
}

}  // namespace plumbline
