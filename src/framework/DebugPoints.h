#pragma once
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "framework/DebugPoint.h"

namespace plumbline {

/// The debug points that are known, by id, with the requests at each. Several points may have one id: what is
/// wanted is wanted at each of them. A thread that passes a point never waits for one that asks.
class DebugPoints {
public:
  struct Info {
    std::string id;
    DebugKind kind;
  };

  DebugPoints() = default;
  ~DebugPoints();
  DebugPoints(const DebugPoints&) = delete;
  DebugPoints& operator=(const DebugPoints&) = delete;

  /// Those of the macros of DebugSite.h, in all of the program.
  static DebugPoints& sites();

  /// Lists an id before its first point comes, so that requests can wait for it there.
  void expect(const std::string& id, DebugKind kind);
  /// The point must live until remove().
  void add(DebugPoint& point);
  /// The same without waiting; false: not now.
  bool tryAdd(DebugPoint& point);
  /// Only when no thread passes it any more.
  void remove(DebugPoint& point);

  /// Sorted by id.
  std::vector<Info> list() const;
  std::optional<DebugKind> find(const std::string& id) const;

  /// False if there is no such point.
  bool attach(const std::string& id, std::shared_ptr<DebugRequest> request);
  void detach(const std::string& id, const std::shared_ptr<DebugRequest>& request);

private:
  struct Entry {
    std::vector<DebugPoint*> points;
    std::shared_ptr<const DebugRequests> requests;
    DebugKind kind = DebugKind::output;
  };
  struct Retired {
    std::shared_ptr<const DebugRequests> requests;
    std::vector<DebugPoint*> points;
  };

  void addLocked(DebugPoint& point);
  void publish(Entry& entry, DebugRequests requests);
  void reclaim();

  mutable std::mutex mutex_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<Retired> retired_;  ///< lists that a thread may still look at
};

}  // namespace plumbline
