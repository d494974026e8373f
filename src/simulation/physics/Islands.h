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
    handles.clear();
    all.clear();
    islandOf.clear();
    for (const auto& [handle, assembly] : assemblies) {
      islandOf.push_back(all.size());
      handles.push_back(handle);
      all.push_back(assembly.get());
    }
    const auto root = [&](std::size_t i) {
      while (islandOf[i] != i) i = islandOf[i];
      return i;
    };
    for (const Contact& contact : contacts) {
      if (contact.assemblyB < 0) continue;
      const std::size_t a = root(placeOf(contact.assemblyA)), b = root(placeOf(contact.assemblyB));
      islandOf[std::max(a, b)] = std::min(a, b);
    }
    for (std::size_t i = 0; i < all.size(); ++i) islandOf[i] = root(i);
    contactIsland.clear();
    for (const Contact& contact : contacts) contactIsland.push_back(islandOf[placeOf(contact.assemblyA)]);
  }

  /// Calls visit(members, contacts) for each island of which something is awake: pointers to its assemblies
  /// by ascending handle, indices of its contacts.
  template <class Visit>
  void forEachAwake(const Visit& visit) {
    for (std::size_t first = 0; first < all.size(); ++first) {
      if (islandOf[first] != first) continue;
      bool awake = false;
      members.clear();
      for (std::size_t i = first; i < all.size(); ++i)
        if (islandOf[i] == first) {
          members.push_back(all[i]);
          awake = awake || !all[i]->asleep();
        }
      if (!awake) continue;
      contactIndices.clear();
      for (std::size_t i = 0; i < contactIsland.size(); ++i)
        if (contactIsland[i] == first) contactIndices.push_back(i);
      visit(members, contactIndices);
    }
  }

  EngineAssembly& assembly(int handle) const { return *all[placeOf(handle)]; }

private:
  std::size_t placeOf(int handle) const {
    return static_cast<std::size_t>(std::lower_bound(handles.begin(), handles.end(), handle) -
                                    handles.begin());
  }

  std::vector<int> handles;                ///< of all assemblies, ascending
  std::vector<EngineAssembly*> all;        ///< the same
  std::vector<std::size_t> islandOf;       ///< by place in these; an island is named by its first member
  std::vector<std::size_t> contactIsland;  ///< by contact
  std::vector<EngineAssembly*> members;
  std::vector<std::size_t> contactIndices;
};

}  // namespace plumbline::simulation
