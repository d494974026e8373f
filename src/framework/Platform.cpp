#include "framework/Platform.h"

#include <map>
#include <string_view>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SelfRegistration.h"

namespace plumbline {
namespace {

std::map<std::string, Platforms::Maker>& platformMakers() {
  static std::map<std::string, Platforms::Maker> map;
  return map;
}

}  // namespace

bool Platforms::add(const std::string& name, Maker maker) {
  if (!platformMakers().emplace(name, maker).second) endLinkedTwice("platforms", name);
  return true;
}

std::vector<std::string> Platforms::names() {
  std::vector<std::string> result;
  for (const auto& entry : platformMakers()) result.push_back(entry.first);
  return result;
}

std::unique_ptr<Platform> Platforms::make(const std::string& name) {
  const auto found = platformMakers().find(name);
  if (found != platformMakers().end()) return found->second();
  const std::vector<std::string> known = names();
  std::string remedy = suggestion(name, known);
  if (remedy.empty()) {
    for (const std::string& other : known) remedy += (remedy.empty() ? "; there are: " : ", ") + other;
  }
  throw ConfigurationError("--platform " + name + ": unknown platform" + remedy);
}

std::string chosenPlatform(int argc, const char* const* argv, const std::string& fallback) {
  constexpr std::string_view option = "--platform";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--") break;
    if (word == option && i + 1 < argc) return argv[i + 1];
    if (word.starts_with(option) && word.substr(option.size()).starts_with('='))
      return std::string(word.substr(option.size() + 1));
  }
  return fallback;
}

}  // namespace plumbline
