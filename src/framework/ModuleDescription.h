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
  /// By name: its loader, with all that streams it, is compiled where a module provides it and nowhere else.
  std::string representation;
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

/// A module's contract, known without making one. Nothing here is inline: each module's source would compile
/// it again.
struct ModuleDescription {
  ModuleDescription(const char* name, const char* file);
  ~ModuleDescription();
  ModuleDescription(const ModuleDescription&) = delete;
  ModuleDescription& operator=(const ModuleDescription&) = delete;

  std::string name;
  std::vector<ModuleInput> inputs;
  std::vector<ModuleOutput> outputs;
  std::string file;  ///< its header, as the compiler was given it
  std::vector<ModuleInputs> inputsOfKinds;
  ParameterList parameters;  ///< their owner is the Module

  /// The folder below modules/ that it lies in ("perception"); empty elsewhere.
  std::string area() const;

  bool add(const char* representation, ModuleInput::Kind kind, void (*bind)(Module&, const Representation*));
  bool add(const RepresentationLoader& representation, void (*update)(Module&, Representation&));
  bool addAll(const char* representationKind, ModuleInput::Kind kind,
              void (*bind)(Module&, const Representation*));
  /// The output of that name, or null.
  const ModuleOutput* output(const std::string& representation) const;
};

}  // namespace plumbline
