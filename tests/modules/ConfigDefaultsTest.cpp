// A default stands in the source alone: a file of config/ has only what differs from what holds without it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "framework/ConfigFile.h"
#include "framework/Module.h"
#include "framework/ModuleParameters.h"
#include "framework/ParameterFiles.h"
#include "framework/Registry.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

/// What has the parameters of a configuration file.
struct Owner {
  const ParameterList* parameters;
  std::shared_ptr<void> object;
};

/// Files of other names are data, as formations and motions.
std::map<std::string, Owner (*)(const std::string&)> owners() {
  std::map<std::string, Owner (*)(const std::string&)> all;
  for (const auto& [name, loader] : Registry::instance().modules())
    all[name] = [](const std::string& module) -> Owner {
      const ModuleLoader& loader = *Registry::instance().modules().at(module);
      return {&loader.description().parameters, loader.create()};
    };
  for (const auto& [name, file] : ParameterFiles::all())
    all[name] = [](const std::string& name) -> Owner {
      const ParameterFile& file = ParameterFiles::all().at(name);
      return {file.parameters, file.make()};
    };
  all["walking"] = [](const std::string&) -> Owner {
    return {&walking::WalkGaits::parameterList(), std::make_shared<walking::WalkGaits>()};
  };
  return all;
}

using Values = std::map<std::string, std::string>;

Values valuesOf(const Owner& owner) {
  Values values;
  owner.parameters->visit(owner.object.get(),
                          [&](const std::string& path, const Parameter&, const ParameterPointer& value) {
                            values[path] = parameterText(value);
                          });
  return values;
}

/// What holds without the file: `before`; of a gait of a walk, what the walk has itself.
std::string without(const std::string& path, const Values& before, const Values& after) {
  constexpr std::size_t of = 2;  // "gaits.forward.step.duration"
  if (!path.starts_with("gaits.") || path.starts_with("gaits.recovery.")) return before.at(path);
  std::size_t from = 0;
  for (std::size_t i = 0; i < of; ++i) from = path.find('.', from) + 1;
  return before.at(path) != before.at(path.substr(from)) ? before.at(path) : after.at(path.substr(from));
}

/// Reads a file into the owner; the paths that it need not name.
std::vector<std::string> repeatedIn(const fs::path& path, const Owner& owner) {
  const Values before = valuesOf(owner);
  const ConfigFile file(path.string());
  readParameters(file.root(), *owner.parameters, owner.object.get());
  const Values after = valuesOf(owner);
  std::vector<std::string> repeated;
  for (const auto& [name, value] : after)
    if (file.root().node(name) && value == without(name, before, after))
      repeated.push_back(path.string() + ": " + name + ": " + value);
  return repeated;
}

TEST(ConfigDefaults, noFileRepeatsWhatHoldsWithoutIt) {
  const auto known = owners();
  int files = 0, values = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator("config")) {
    const fs::path& path = entry.path();
    const auto kind = known.find(path.stem().string());
    if (path.extension() != ".yaml" || kind == known.end()) continue;
    const Owner owner = kind->second(kind->first);
    // What a robot or a walk has of its own lies over what all have; what is put over a chosen walk, over
    // that.
    for (const fs::path& below :
         {fs::path("config") / path.filename(), path.parent_path().parent_path() / path.filename()})
      if (fs::exists(below) && !fs::equivalent(below, path)) repeatedIn(below, owner);
    const Values before = valuesOf(owner);
    for (const std::string& repeated : repeatedIn(path, owner)) ADD_FAILURE() << repeated;
    ++files;
    for (const auto& [name, value] : valuesOf(owner))
      if (value != before.at(name)) ++values;
  }
  EXPECT_GT(files, 20);
  EXPECT_GT(values, 500);
}

}  // namespace
}  // namespace plumbline
