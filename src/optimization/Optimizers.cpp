#include "optimization/Optimizers.h"

#include <stdexcept>
#include <tuple>

#include "framework/SelfRegistration.h"

namespace plumbline {

namespace {

std::vector<OptimizerKind>& registeredKinds() {
  static std::vector<OptimizerKind> kinds;
  return kinds;
}

}  // namespace

OptimizerLoader::OptimizerLoader(const OptimizerKind& kind) {
  registerInOrder(registeredKinds(), kind, "optimisers",
                  [](const OptimizerKind& k) { return std::tuple(k.order, std::string_view(k.name)); });
}

const std::vector<std::string>& optimizerNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const OptimizerKind& kind : registeredKinds()) list.emplace_back(kind.name);
    return list;
  }();
  return names;
}

std::unique_ptr<Optimizer> makeOptimizer(std::string_view name, const SearchSpace& space,
                                         const OptimizerOptions& options) {
  for (const OptimizerKind& kind : registeredKinds())
    if (kind.name == name) return kind.make(space, options);
  std::string known;
  for (const std::string& other : optimizerNames()) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument("unknown optimiser \"" + std::string(name) + "\"; there are: " + known);
}

}  // namespace plumbline
