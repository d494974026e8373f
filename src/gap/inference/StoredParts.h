#pragma once
#include <functional>
#include <string>

#include "gap/inference/InferenceMemory.h"

namespace plumbline::gap {

/// What the part's name ends with that leaves a group out.
inline std::string nameWithout(std::size_t group) { return " without group " + std::to_string(group); }

/// Runs the searches and fits of a diagnosis, or takes what a run that was stopped has stored of them. Each
/// depends on what came before by its result alone, so the whole comes to the same bytes.
class StoredParts {
public:
  /// memory: null, or outlives this object. replays: how many were asked for so far.
  StoredParts(InferenceMemory* memory, std::function<std::size_t()> replays)
      : memory_(memory), asked_(std::move(replays)) {}

  /// groups: how many the search is to judge sets by.
  bool holdsSearch(const std::string& name, std::size_t groups) const {
    return memory_ && memory_->search(name, groups);
  }
  /// Stored or not, only the causes of the sets' fits are returned.
  BeamResult search(const std::string& name, std::size_t groups, const std::function<BeamResult()>& run);
  Explanation values(const std::string& name, const std::function<Explanation()>& run);
  /// Runs what is needed for searches alone: how often depends on what is stored.
  void uncounted(const std::function<void()>& run);
  /// All that were asked for by now, those of stored parts as well.
  std::size_t replays() const { return asked_() + stored_ - uncounted_; }

private:
  InferenceMemory* memory_;
  std::function<std::size_t()> asked_;
  std::size_t stored_ = 0, uncounted_ = 0;
};

}  // namespace plumbline::gap
