#include "framework/Plugin.h"

#include <map>

namespace plumbline {
namespace {

std::map<std::string, Plugins::Maker>& pluginMakers() {
  static std::map<std::string, Plugins::Maker> map;
  return map;
}

}  // namespace

bool Plugins::add(const std::string& name, Maker maker) { return pluginMakers().emplace(name, maker).second; }

std::vector<std::unique_ptr<Plugin>> Plugins::make() {
  std::vector<std::unique_ptr<Plugin>> result;
  for (const auto& [name, maker] : pluginMakers()) result.push_back(maker());
  return result;
}

}  // namespace plumbline
