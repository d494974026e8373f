#pragma once
#include <map>
#include <memory>
#include <string>

#include "framework/ModuleDescription.h"

namespace plumbline {

/// Makes modules of one type. Loaders made by MAKE_MODULE register themselves.
class ModuleLoader {
public:
  virtual ~ModuleLoader() = default;
  virtual const ModuleDescription& description() const = 0;
  virtual std::unique_ptr<Module> create() const = 0;
};

/// All modules and representations linked into the program, by name. Filled before main, read-only after.
class Registry {
public:
  static Registry& instance();

  /// Adds a module and every representation it can provide. A second module of the same name ends the program
  /// start: that is a mistake of the build.
  void add(const ModuleLoader& loader);

  const std::map<std::string, const ModuleLoader*>& modules() const { return modules_; }
  const std::map<std::string, const RepresentationLoader*>& representations() const;

private:
  std::map<std::string, const ModuleLoader*> modules_;
  mutable std::map<std::string, const RepresentationLoader*> representations_;
};

template <typename M>
class ModuleLoaderOf final : public ModuleLoader {
public:
  ModuleLoaderOf() { Registry::instance().add(*this); }
  const ModuleDescription& description() const override { return M::moduleDescription(); }
  std::unique_ptr<Module> create() const override { return std::make_unique<M>(); }
};

}  // namespace plumbline
