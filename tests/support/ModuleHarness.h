#pragma once
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "framework/Module.h"
#include "framework/ModuleParameters.h"

namespace plumbline::test {

/// One module alone, without modules.cfg: the test fills its inputs, runs cycles and looks at its outputs.
/// Required inputs that it does not fill must be what some module in the program provides.
///
///     ModuleHarness<BallLocator> harness;              // reads config/BallLocator.yaml
///     harness.input<BallPercept>().seen = true;        // an input never asked for is not provided (null)
///     harness.cycle();
///     EXPECT_TRUE(harness.output<BallPos>().known);
template <typename M>
class ModuleHarness {
public:
  explicit ModuleHarness(std::vector<std::string> configDirectories = {"config"})
      : config_(std::move(configDirectories)) {}

  /// Objects for the module; before the first cycle.
  ModuleObjects& objects() { return objects_; }
  StopSignal& stop() { return stop_; }
  /// An input to be filled; before the first cycle. The reference stays valid. Those of a kind that the
  /// module reads come in the order of these calls.
  template <typename R>
  R& input() {
    return static_cast<R&>(representation(representationLoader<R>()));
  }
  template <typename R>
  const R& output() {
    return static_cast<const R&>(representation(representationLoader<R>()));
  }
  /// The module, made and initialised now if it is not yet.
  M& module() {
    init();
    return static_cast<M&>(*module_);
  }
  /// Execute and all updates, in the order of PROVIDES.
  void cycle(std::size_t times = 1) {
    init();
    for (std::size_t i = 0; i < times; ++i) {
      module_->execute();
      for (const ModuleOutput& output : M::moduleDescription().outputs) {
        output.update(*module_, representation(*output.representation));
      }
    }
  }

private:
  void init() {
    if (module_) return;
    ModuleContext context{M::moduleDescription().name, "test", config_, objects_, stop_};
    {
      ModuleContext::Scope scope(context);
      module_ = std::make_unique<M>();
    }
    configureModule(*module_, M::moduleDescription(), config_);
    for (const ModuleInput& input : M::moduleDescription().inputs) {
      if (input.kind == ModuleInput::Kind::required && !representations_.contains(input.representation))
        representation(*Registry::instance().representations().at(input.representation));
      const auto found = representations_.find(input.representation);
      input.bind(*module_, found == representations_.end() ? nullptr : &found->second->get());
    }
    for (const ModuleInputs& all : M::moduleDescription().inputsOfKinds) {
      for (const auto& [loader, holder] : inOrder_) {
        if (loader->kind() == all.representationKind) all.bind(*module_, &holder->get());
      }
    }
    module_->init();
  }

  Representation& representation(const RepresentationLoader& loader) {
    auto& holder = representations_[loader.name()];
    if (!holder) {
      holder = loader.create();
      inOrder_.emplace_back(&loader, holder.get());
    }
    return holder->get();
  }

  ConfigStore config_;
  ModuleObjects objects_;
  StopSignal stop_;
  std::map<std::string, std::unique_ptr<RepresentationHolder>> representations_;
  std::vector<std::pair<const RepresentationLoader*, RepresentationHolder*>> inOrder_;
  std::unique_ptr<Module> module_;
};

}  // namespace plumbline::test
