// What stands in doc/reference/platforms.md is what the modules' contracts say.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "framework/Platform.h"
#include "framework/Registry.h"

namespace plumbline {
namespace {

using Names = std::set<std::string>;

/// The folder of src/modules/ of a module; empty for one of the tests.
std::string folderOf(const ModuleDescription& module) {
  return module.file.find("src/modules/") == std::string::npos ? std::string() : module.area();
}

bool isPlatform(const std::string& folder) {
  for (const std::string& name : Platforms::names())
    if (name == folder) return true;
  return false;
}

/// The modules that the files of config/modules name: those of every platform.
Names sharedModules() {
  Names modules;
  for (const auto& entry : std::filesystem::directory_iterator("config/modules")) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line.substr(0, line.find('#')));
      std::string module;
      if (words >> module) modules.insert(module);
    }
  }
  return modules;
}

struct Seam {
  /// What platform-independent modules read and none of them provides: those of config/modules, all others.
  Names required, optional;
  Names fromPlatforms;  ///< what modules of platforms can provide
};

Seam seamOfModules() {
  Seam seam;
  Names provided;
  const Names shared = sharedModules();
  for (const auto& [name, loader] : Registry::instance().modules()) {
    const ModuleDescription& module = loader->description();
    const std::string folder = folderOf(module);
    if (folder.empty()) continue;
    for (const ModuleOutput& output : module.outputs)
      (isPlatform(folder) ? seam.fromPlatforms : provided).insert(output.representation->name());
  }
  for (const auto& [name, loader] : Registry::instance().modules()) {
    const ModuleDescription& module = loader->description();
    const std::string folder = folderOf(module);
    if (folder.empty() || isPlatform(folder)) continue;
    for (const ModuleInput& input : module.inputs) {
      const std::string& representation = input.representation;
      if (provided.contains(representation)) continue;
      const bool needed = input.kind == ModuleInput::Kind::required && shared.contains(name);
      (needed ? seam.required : seam.optional).insert(representation);
    }
  }
  for (const std::string& representation : seam.required) seam.optional.erase(representation);
  return seam;
}

/// The names in the first column of the table below a heading of the page.
Names listed(const std::string& heading) {
  std::ifstream page("doc/reference/platforms.md");
  Names names;
  bool below = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) below = line == "## " + heading;
    const auto end = line.find('`', 3);
    if (below && line.starts_with("| `") && end != std::string::npos) names.insert(line.substr(3, end - 3));
  }
  return names;
}

TEST(PlatformSeam, thePageListsWhatAPlatformMustGive) {
  EXPECT_EQ(listed("What a platform provides"), seamOfModules().required);
}

TEST(PlatformSeam, thePageListsWhatAPlatformMayGive) {
  EXPECT_EQ(listed("What a platform may provide"), seamOfModules().optional);
}

TEST(PlatformSeam, simsparkGivesAllOfIt) {
  const Seam seam = seamOfModules();
  for (const std::string& representation : seam.required)
    EXPECT_TRUE(seam.fromPlatforms.contains(representation)) << representation;
}

TEST(PlatformSeam, theSharedFilesNameNoModuleOfAPlatform) {
  for (const std::string& module : sharedModules()) {
    const auto found = Registry::instance().modules().find(module);
    ASSERT_NE(found, Registry::instance().modules().end()) << module;
    EXPECT_FALSE(isPlatform(folderOf(found->second->description()))) << module;
  }
}

}  // namespace
}  // namespace plumbline
