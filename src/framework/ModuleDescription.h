#pragma once
#include <string>
#include <vector>

#include "framework/RepresentationLoader.h"

namespace plumbline {

class Module;

/// What a module reads: filled in by REQUIRES, REQUIRES_IF_PROVIDED and USES.
struct ModuleInput {
  enum class Kind { required, requiredIfProvided, used };
  const RepresentationLoader* representation;
  Kind kind;
  /// Sets the module's pointer `theName`; null for "not provided".
  void (*bind)(Module& module, const Representation* representation);
};

/// What a module can provide: filled in by PROVIDES.
struct ModuleOutput {
  const RepresentationLoader* representation;
  void (*update)(Module& module, Representation& representation);
};

/// A module's contract, known without making one.
struct ModuleDescription {
  std::string name;
  std::vector<ModuleInput> inputs;
  std::vector<ModuleOutput> outputs;

  bool add(const RepresentationLoader& representation, ModuleInput::Kind kind,
           void (*bind)(Module&, const Representation*)) {
    inputs.push_back({&representation, kind, bind});
    return true;
  }
  bool add(const RepresentationLoader& representation, void (*update)(Module&, Representation&)) {
    outputs.push_back({&representation, update});
    return true;
  }
  /// The output of that name, or null.
  const ModuleOutput* output(const std::string& representation) const {
    for (const ModuleOutput& output : outputs) {
      if (output.representation->name() == representation) return &output;
    }
    return nullptr;
  }
};

}  // namespace plumbline
