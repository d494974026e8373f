#include "situation/SituationKinds.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "framework/LinkedTwice.h"

namespace plumbline {
namespace {

using Kinds = std::vector<std::unique_ptr<const SituationKind>>;

Kinds& registeredKinds() {
  static Kinds kinds;
  return kinds;
}

std::string_view nameOf(const std::unique_ptr<const SituationKind>& kind) { return kind->traits.name; }

auto placeOf(const std::unique_ptr<const SituationKind>& kind) {
  return std::tuple(kind->traits.order, nameOf(kind));
}

}  // namespace

SituationKindLoader::SituationKindLoader(std::unique_ptr<const SituationKind> kind) {
  Kinds& kinds = registeredKinds();
  if (std::ranges::count(kinds, nameOf(kind), nameOf) > 0)
    endLinkedTwice("kinds of situations", kind->traits.name);
  const auto next = std::ranges::upper_bound(kinds, placeOf(kind), {}, placeOf);
  kinds.insert(next, std::move(kind));
}

const Kinds& situationKinds() { return registeredKinds(); }

std::vector<std::string> situationKindNames() {
  std::vector<std::string> names;
  for (const auto& kind : registeredKinds()) names.emplace_back(kind->traits.name);
  return names;
}

const SituationKind& situationKind(std::string_view name) {
  for (const auto& kind : registeredKinds())
    if (kind->traits.name == name) return *kind;
  throw std::invalid_argument("there is no kind of situation \"" + std::string(name) + "\"");
}

}  // namespace plumbline
