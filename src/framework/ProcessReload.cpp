// The life of a process's modules: replaced one by one, and when configuration files have changed.
#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/Process.h"

namespace plumbline {

bool Process::reads(std::size_t index, const std::string& file) const {
  const ModuleDescription& description = plan_.modules[index].loader->description();
  return (description.name == file && !description.parameters.empty()) ||
         config_.filesOf(description.name).contains(file);
}

void Process::takeParameters(std::size_t index, Module& from) {
  const ParameterList& parameters = plan_.modules[index].loader->description().parameters;
  std::map<std::string, ParameterValue> next, before;
  parameters.visit(&from, [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
    next.emplace(path, parameterValue(pointer));
  });
  const auto set = [&](const std::map<std::string, ParameterValue>& values) {
    parameters.visit(modules_[index].get(),
                     [&](const std::string& path, const Parameter&, const ParameterPointer& pointer) {
                       before.emplace(path, parameterValue(pointer));
                       setParameterValue(pointer, values.at(path));
                     });
    modules_[index]->parametersChanged();
  };
  try {
    set(next);
    debug_->accepted(index);
  } catch (const std::exception&) {
    const auto old = before;
    set(old);
    throw;
  }
}

std::string Process::remakeReaders(const std::string& file, const std::function<void()>& accept) {
  struct Next {
    std::size_t index;
    std::unique_ptr<Module> module;
    bool parametersAlone;
  };
  std::vector<Next> all;
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    if (!reads(i, file)) continue;
    const std::string& name = plan_.modules[i].loader->description().name;
    all.push_back({i, makeModule(i), !config_.filesOf(name).contains(file)});
    if (all.back().parametersAlone) continue;
    connectModule(*all.back().module, i);
    initModule(*all.back().module, i);
  }
  accept();
  std::string done;
  for (Next& next : all) {
    const std::string& name = plan_.modules[next.index].loader->description().name;
    done += (done.empty() ? "" : ", ") + name + (next.parametersAlone ? " goes on with it" : " began anew");
    if (next.parametersAlone)
      takeParameters(next.index, *next.module);
    else
      replaceModule(next.index, std::move(next.module));
  }
  return done;
}

std::string Process::reload(const std::string& file) {
  ConfigStore::ChangedFile changed(config_, file);
  const std::string done = remakeReaders(file, [&] { changed.checkUnknown(); });
  const bool alone = config_.version() == configVersion_;
  changed.keep();
  if (alone) configVersion_ = config_.version();
  return done;
}

void Process::followReloads() {
  const std::uint64_t now = config_.version();
  for (const std::string& file : config_.changedSince(configVersion_)) {
    try {
      remakeReaders(file, [] {});
    } catch (const std::exception& error) {
      log_.error() << "[" << info_.name << "] " << error.what() << "; the modules here stay as they are";
    }
  }
  configVersion_ = now;
}

void Process::runCommands() {
  debug_->runCommands(
      [this](std::size_t index) {
        resetModule(index);
        return plan_.modules[index].loader->description().name + " began anew";
      },
      [this](const std::string& file) { return reload(file); });
}

}  // namespace plumbline
