#pragma once
#include <string>
#include <vector>

#include "framework/RepresentationLoader.h"
#include "parameters/Parameter.h"

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

/// All representations of one kind: filled in by REQUIRES_ALL and USES_ALL. The module graph makes a
/// ModuleInput of each that the module's thread has.
struct ModuleInputs {
  std::string representationKind;
  ModuleInput::Kind kind;
  /// Appends to the module's list.
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
  std::string file;  ///< its header, as the compiler was given it
  std::vector<ModuleInputs> inputsOfKinds{};
  ParameterList parameters{};  ///< their owner is the Module

  /// The folder below modules/ that it lies in ("perception"); empty elsewhere.
  std::string area() const {
    const std::string mark = "modules/";
    const auto at = file.rfind(mark);
    if (at == std::string::npos) return {};
    const auto begin = at + mark.size(), end = file.find('/', begin);
    return end == std::string::npos ? std::string() : file.substr(begin, end - begin);
  }

  bool add(const RepresentationLoader& representation, ModuleInput::Kind kind,
           void (*bind)(Module&, const Representation*)) {
    inputs.push_back({&representation, kind, bind});
    return true;
  }
  bool add(const RepresentationLoader& representation, void (*update)(Module&, Representation&)) {
    outputs.push_back({&representation, update});
    return true;
  }
  bool addAll(const std::string& representationKind, ModuleInput::Kind kind,
              void (*bind)(Module&, const Representation*)) {
    inputsOfKinds.push_back({representationKind, kind, bind});
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
