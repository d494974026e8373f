#include "framework/DebugPoints.h"

#include <algorithm>

namespace plumbline {

DebugPoints& DebugPoints::sites() {
  // Never destroyed: points without any destructor refer to it until the very end.
  static auto* points = new DebugPoints;
  return *points;
}

DebugPoints::~DebugPoints() {
  for (auto& [id, entry] : entries_) {
    for (DebugPoint* point : entry.points) {
      point->requests_.store(nullptr);
      point->state_.store(DebugPoint::State::unknown);
    }
  }
}

void DebugPoints::addLocked(DebugPoint& point) {
  if (point.state_.load() != DebugPoint::State::unknown) return;  // another thread was faster
  Entry& entry = entries_[point.id()];
  entry.kind = point.kind();
  entry.points.push_back(&point);
  point.requests_.store(entry.requests.get());
  point.state_.store(entry.requests ? DebugPoint::State::on : DebugPoint::State::off);
}

void DebugPoints::expect(const std::string& id, DebugKind kind) {
  const std::lock_guard lock(mutex_);
  const auto [entry, isNew] = entries_.try_emplace(id);
  if (isNew) entry->second.kind = kind;
}

void DebugPoints::add(DebugPoint& point) {
  const std::lock_guard lock(mutex_);
  addLocked(point);
}

bool DebugPoints::tryAdd(DebugPoint& point) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return false;
  addLocked(point);
  return true;
}

void DebugPoints::remove(DebugPoint& point) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(std::string_view(point.id()));
  if (found == entries_.end()) return;
  std::erase(found->second.points, &point);
  for (Retired& retired : retired_) std::erase(retired.points, &point);
  if (found->second.points.empty()) entries_.erase(found);
  point.requests_.store(nullptr);
  point.state_.store(DebugPoint::State::unknown);
}

std::vector<DebugPoints::Info> DebugPoints::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<Info> result;
  for (const auto& [id, entry] : entries_) result.push_back({id, entry.kind});
  return result;
}

std::optional<DebugKind> DebugPoints::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end()) return std::nullopt;
  return found->second.kind;
}

void DebugPoints::publish(Entry& entry, DebugRequests requests) {
  std::shared_ptr<const DebugRequests> next;
  if (!requests.empty()) next = std::make_shared<const DebugRequests>(std::move(requests));
  for (DebugPoint* point : entry.points) {
    point->requests_.store(next.get(), std::memory_order_seq_cst);
    point->state_.store(next ? DebugPoint::State::on : DebugPoint::State::off);
  }
  if (entry.requests) retired_.push_back({std::move(entry.requests), entry.points});
  entry.requests = std::move(next);
  reclaim();
}

void DebugPoints::reclaim() {
  std::erase_if(retired_, [](const Retired& retired) {
    return std::ranges::all_of(retired.points, [](const DebugPoint* point) {
      return point->readers_.load(std::memory_order_seq_cst) == 0;
    });
  });
}

bool DebugPoints::attach(const std::string& id, std::shared_ptr<DebugRequest> request) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end()) return false;
  DebugRequests requests = found->second.requests ? *found->second.requests : DebugRequests();
  requests.push_back(std::move(request));
  publish(found->second, std::move(requests));
  return true;
}

void DebugPoints::detach(const std::string& id, const std::shared_ptr<DebugRequest>& request) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end() || !found->second.requests) return;
  DebugRequests requests = *found->second.requests;
  std::erase(requests, request);
  publish(found->second, std::move(requests));
}

}  // namespace plumbline
