#include "framework/Registry.h"

#include "framework/SelfRegistration.h"

namespace plumbline {

Registry& Registry::instance() {
  static Registry registry;
  return registry;
}

void Registry::add(const ModuleLoader& loader) {
  const std::string& name = loader.description().name;
  if (!modules_.emplace(name, &loader).second) endLinkedTwice("modules", name);
}

const std::map<std::string, const RepresentationLoader*>& Registry::representations() const {
  // A module's description is complete only when all static objects are made: so not in add().
  if (representations_.empty()) {
    for (const auto& [name, loader] : modules_) {
      for (const auto& output : loader->description().outputs) {
        representations_.emplace(output.representation->name(), output.representation);
      }
    }
  }
  return representations_;
}

}  // namespace plumbline
