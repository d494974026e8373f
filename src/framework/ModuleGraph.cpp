#include "framework/ModuleGraph.h"

#include <algorithm>
#include <map>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "framework/SpecialModule.h"

namespace plumbline {
namespace {

template <typename T>
void appendKeys(std::vector<std::string>& names, const std::map<std::string, T>& map) {
  for (const auto& entry : map) names.push_back(entry.first);
}

std::string joined(const std::vector<std::string>& words, const std::string& last) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    result += (i == 0 ? "" : i + 1 < words.size() ? ", " : last) + words[i];
  }
  return result;
}

class Planner {
public:
  Planner(const ModulesConfig& config, const Registry& registry) : config_(config), registry_(registry) {}

  std::vector<ThreadPlan> plan() {
    for (const ThreadConfig& thread : config_.threads) {
      if (registry_.modules().count(thread.name) || SpecialModules::makers().count(thread.name)) {
        fail(thread, "thread " + thread.name + " has the name of a module");
      }
    }
    for (const ThreadConfig& thread : config_.threads) {
      plans_.push_back({thread.name, thread.priority, {}, {}, {}, thread.rate});
      providers_.emplace_back();
      for (const ModulesConfigLine& line : thread.lines) add(line);
      if (plans_.back().modules.empty() && plans_.back().specials.empty()) {
        fail(thread, "thread " + thread.name + " has no modules");
      }
    }
    for (ThreadPlan& thread : plans_) {
      for (const CopyPlan& copy : thread.copies) checkCopy(thread, copy);
      for (ModulePlan& module : thread.modules) {
        module.inputs = inputsOf(thread, module);
        checkInputs(thread, module);
      }
    }
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      const std::vector<std::string>& order = config_.threads[i].order;
      std::ranges::stable_sort(plans_[i].modules, {}, [&](const ModulePlan& module) {
        return std::ranges::find(order, module.loader->description().name) - order.begin();
      });
      sortModules(plans_[i]);
    }
    return std::move(plans_);
  }

private:
  /// at: a line, section, module or copy; it knows its file and line.
  template <typename At>
  [[noreturn]] static void fail(const At& at, const std::string& message) {
    throw ConfigurationError(at.path + ":" + std::to_string(at.line) + ": " + message);
  }

  /// Where something else is, for an error at `at`.
  static std::string whereIs(const std::string& path, int line, const ModulesConfigLine& at) {
    return (path == at.path ? "line " : path + ":") + std::to_string(line);
  }

  bool isThread(const std::string& name) const {
    return std::any_of(config_.threads.begin(), config_.threads.end(),
                       [&](const ThreadConfig& thread) { return thread.name == name; });
  }

  const RepresentationLoader& representation(const ModulesConfigLine& line) const {
    const auto& known = registry_.representations();
    const auto found = known.find(line.representation);
    if (found != known.end()) return *found->second;
    std::vector<std::string> names;
    appendKeys(names, known);
    fail(line, "unknown representation " + line.representation + suggestion(line.representation, names));
  }

  void add(const ModulesConfigLine& line) {
    const auto module = registry_.modules().find(line.provider);
    if (module != registry_.modules().end()) {
      addModule(line, *module->second);
    } else if (SpecialModules::makers().count(line.provider)) {
      addSpecial(line);
    } else if (isThread(line.provider) && !line.representation.empty()) {
      addCopy(line);
    } else {
      std::vector<std::string> names;
      appendKeys(names, registry_.modules());
      appendKeys(names, SpecialModules::makers());
      if (!line.representation.empty() && config_.threads.size() > 1) {
        for (const ThreadConfig& thread : config_.threads) names.push_back(thread.name);
      }
      const bool mayBeThread = !line.representation.empty() && config_.threads.size() > 1;
      fail(line, (!mayBeThread ? "unknown module " : "unknown module or thread ") + line.provider +
                     suggestion(line.provider, names));
    }
  }

  void addModule(const ModulesConfigLine& line, const ModuleLoader& loader) {
    const auto [entry, isNew] =
        threadOfModule_.emplace(line.provider, Place{plans_.size() - 1, line.line, line.path});
    const Place& first = entry->second;
    if (first.thread != plans_.size() - 1) {
      fail(line, "module " + line.provider + " is already in thread " + plans_[first.thread].name + " (" +
                     whereIs(first.path, first.line, line) + "); a module runs in one thread");
    }
    auto& modules = plans_.back().modules;
    if (isNew) modules.push_back({&loader, line.line, {}, {}, line.path});
    if (line.representation.empty()) return;
    representation(line);
    const ModuleOutput* output = loader.description().output(line.representation);
    if (!output) {
      std::vector<std::string> possible;
      for (const auto& other : loader.description().outputs) possible.push_back(other.representation->name());
      fail(line, "module " + line.provider + " cannot provide " + line.representation + ", only " +
                     (possible.empty() ? "be executed" : joined(possible, " and ")));
    }
    provide(line);
    const auto self = std::find_if(modules.begin(), modules.end(),
                                   [&](const ModulePlan& plan) { return plan.loader == &loader; });
    self->outputs.push_back(output);
  }

  void addSpecial(const ModulesConfigLine& line) {
    auto& specials = plans_.back().specials;
    auto self = std::find_if(specials.begin(), specials.end(),
                             [&](const SpecialPlan& plan) { return plan.name == line.provider; });
    if (self == specials.end()) self = specials.insert(self, {line.provider, {}});
    if (line.representation.empty()) {
      self->alone = true;
      return;
    }
    const RepresentationLoader& loader = representation(line);
    provide(line);
    self->representations.push_back(&loader);
  }

  void addCopy(const ModulesConfigLine& line) {
    if (line.provider == plans_.back().name) {
      fail(line, "thread " + line.provider + " cannot copy " + line.representation + " from itself");
    }
    const RepresentationLoader& loader = representation(line);
    provide(line);
    plans_.back().copies.push_back({line.provider, &loader, line.line, line.path});
  }

  /// Notes who provides a representation in the current thread.
  void provide(const ModulesConfigLine& line) {
    const auto [entry, isNew] = providers_.back().emplace(line.representation, &line);
    if (isNew) return;
    fail(line, "representation " + line.representation + " is already provided by " +
                   entry->second->provider + " in thread " + plans_.back().name + " (" +
                   whereIs(entry->second->path, entry->second->line, line) + ")");
  }

  std::size_t indexOf(const std::string& thread) const {
    std::size_t i = 0;
    while (plans_[i].name != thread) i++;
    return i;
  }

  /// Follows a chain of copies to the thread where the representation is made.
  void checkCopy(const ThreadPlan& thread, const CopyPlan& copy) const {
    const std::string& name = copy.representation->name();
    std::size_t at = indexOf(copy.fromThread);
    for (std::size_t hops = 0; hops <= plans_.size(); ++hops) {
      const auto provider = providers_[at].find(name);
      if (provider == providers_[at].end()) {
        fail(copy, "no provider for representation " + name + " in thread " + plans_[at].name +
                       ", from where thread " + thread.name + " copies it");
      }
      if (!isThread(provider->second->provider)) return;
      at = indexOf(provider->second->provider);
    }
    fail(copy,
         "representation " + name + " is copied between threads in a circle, and no module provides it");
  }

  /// The module's inputs, those of kinds in the order of the lines.
  std::vector<ModuleInput> inputsOf(const ThreadPlan& thread, const ModulePlan& module) const {
    const ModuleDescription& description = module.loader->description();
    std::vector<ModuleInput> inputs = description.inputs;
    std::map<const ModulesConfigLine*, const RepresentationLoader*> byLine;  // the lines are in one vector
    for (const auto& [name, line] : providers_[indexOf(thread.name)])
      byLine[line] = registry_.representations().at(name);
    for (const ModuleInputs& all : description.inputsOfKinds) {
      for (const auto& [line, loader] : byLine) {
        if (loader->kind() == all.representationKind) inputs.push_back({loader->name(), all.kind, all.bind});
      }
    }
    return inputs;
  }

  void checkInputs(const ThreadPlan& thread, const ModulePlan& module) const {
    const auto& providers = providers_[indexOf(thread.name)];
    for (const ModuleInput& input : module.inputs) {
      const std::string& name = input.representation;
      if (input.kind != ModuleInput::Kind::required || providers.count(name)) continue;
      fail(module, "no provider for representation " + name + " required by module " +
                       module.loader->description().name + " in thread " + thread.name + remedy(name));
    }
  }

  std::string remedy(const std::string& name) const {
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      if (providers_[i].count(name))
        return "; add \"" + plans_[i].name + " " + name + "\" to copy it from there";
    }
    std::vector<std::string> able;
    for (const auto& [module, loader] : registry_.modules()) {
      if (loader->description().output(name)) able.push_back("\"" + module + " " + name + "\"");
    }
    if (able.size() > 3) able.resize(3);
    return able.empty() ? "" : "; add " + joined(able, " or ");
  }

  struct Place {
    std::size_t thread;
    int line;
    std::string path;
  };
  const ModulesConfig& config_;
  const Registry& registry_;
  std::vector<ThreadPlan> plans_;
  std::vector<std::map<std::string, const ModulesConfigLine*>> providers_;  // by thread and representation
  std::map<std::string, Place> threadOfModule_;
};

}  // namespace

std::string ThreadPlan::provider(const std::string& representation) const {
  for (const CopyPlan& copy : copies) {
    if (copy.representation->name() == representation) return copy.fromThread;
  }
  for (const SpecialPlan& special : specials) {
    for (const auto* loader : special.representations) {
      if (loader->name() == representation) return special.name;
    }
  }
  for (const ModulePlan& module : modules) {
    for (const ModuleOutput* output : module.outputs) {
      if (output->representation->name() == representation) return module.loader->description().name;
    }
  }
  return "";
}

std::vector<ThreadPlan> planThreads(const ModulesConfig& config, const Registry& registry) {
  return Planner(config, registry).plan();
}

}  // namespace plumbline
