#include "situation/SituationKinds.h"

#include <stdexcept>
#include <tuple>

#include "framework/SelfRegistration.h"

namespace plumbline {
namespace {

using Kinds = std::vector<std::unique_ptr<const SituationKind>>;

Kinds& registeredKinds() {
  static Kinds kinds;
  return kinds;
}

}  // namespace

SituationKindLoader::SituationKindLoader(std::unique_ptr<const SituationKind> kind) {
  registerInOrder(registeredKinds(), std::move(kind), "kinds of situations",
                  [](const std::unique_ptr<const SituationKind>& k) {
                    return std::tuple(k->traits.order, std::string_view(k->traits.name));
                  });
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
