#include "framework/ModuleObjects.h"

namespace plumbline {
namespace {

std::map<const void*, ModuleObjects::Maker>& makers() {
  static std::map<const void*, ModuleObjects::Maker> map;
  return map;
}

}  // namespace

bool ModuleObjects::addMaker(const void* key, Maker maker) { return makers().emplace(key, maker).second; }

void ModuleObjects::setObject(const void* key, std::shared_ptr<void> object) {
  std::lock_guard lock(mutex_);
  objects_[key] = std::move(object);
}

void* ModuleObjects::findObject(const void* key) {
  std::lock_guard lock(mutex_);
  auto found = objects_.find(key);
  if (found == objects_.end()) {
    const auto maker = makers().find(key);
    if (maker == makers().end()) return nullptr;
    found = objects_.emplace(key, maker->second()).first;
  }
  return found->second.get();
}

}  // namespace plumbline
