#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "simulation/physics/Physics.h"

namespace plumbline::simulation {

/// Assemblies of one engine by handle; ordered, so that the order of contacts is a matter of the calls alone.
template <class EngineAssembly>
using AssemblyMap = std::map<int, std::unique_ptr<EngineAssembly>>;

/// Which assemblies touch each other, directly or over others: an island of them moves by itself.
/// `EngineAssembly` is an engine's own assembly, with asleep().
template <class EngineAssembly>
class Islands {
public:
  void find(const AssemblyMap<EngineAssembly>& assemblies, const std::vector<Contact>& contacts) {
    handles_.clear();
    all_.clear();
    islandOf_.clear();
    for (const auto& [handle, assembly] : assemblies) {
      islandOf_.push_back(all_.size());
      handles_.push_back(handle);
      all_.push_back(assembly.get());
    }
    const auto root = [&](std::size_t i) {
      while (islandOf_[i] != i) i = islandOf_[i];
      return i;
    };
    for (const Contact& contact : contacts) {
      if (contact.assemblyB < 0) continue;
      const std::size_t a = root(placeOf(contact.assemblyA)), b = root(placeOf(contact.assemblyB));
      islandOf_[std::max(a, b)] = std::min(a, b);
    }
    for (std::size_t i = 0; i < all_.size(); ++i) islandOf_[i] = root(i);
    contactIsland_.clear();
    for (const Contact& contact : contacts) contactIsland_.push_back(islandOf_[placeOf(contact.assemblyA)]);
  }

  /// Calls visit(members, contacts) for each island of which something is awake: pointers to its assemblies
  /// by ascending handle, indices of its contacts.
  template <class Visit>
  void forEachAwake(const Visit& visit) {
    for (std::size_t first = 0; first < all_.size(); ++first) {
      if (islandOf_[first] != first) continue;
      bool awake = false;
      members_.clear();
      for (std::size_t i = first; i < all_.size(); ++i)
        if (islandOf_[i] == first) {
          members_.push_back(all_[i]);
          awake = awake || !all_[i]->asleep();
        }
      if (!awake) continue;
      contactIndices_.clear();
      for (std::size_t i = 0; i < contactIsland_.size(); ++i)
        if (contactIsland_[i] == first) contactIndices_.push_back(i);
      visit(members_, contactIndices_);
    }
  }

  EngineAssembly& assembly(int handle) const { return *all_[placeOf(handle)]; }

private:
  std::size_t placeOf(int handle) const {
    return static_cast<std::size_t>(std::lower_bound(handles_.begin(), handles_.end(), handle) -
                                    handles_.begin());
  }

  std::vector<int> handles_;                ///< of all assemblies, ascending
  std::vector<EngineAssembly*> all_;        ///< the same
  std::vector<std::size_t> islandOf_;       ///< by place in these; an island is named by its first member
  std::vector<std::size_t> contactIsland_;  ///< by contact
  std::vector<EngineAssembly*> members_;
  std::vector<std::size_t> contactIndices_;
};

}  // namespace plumbline::simulation
