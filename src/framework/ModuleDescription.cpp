#include "framework/ModuleDescription.h"

namespace plumbline {

ModuleDescription::ModuleDescription(const char* itsName, const char* itsFile)
    : name(itsName), file(itsFile) {}

ModuleDescription::~ModuleDescription() = default;

std::string ModuleDescription::area() const {
  const std::string mark = "modules/";
  const auto at = file.rfind(mark);
  if (at == std::string::npos) return {};
  const auto begin = at + mark.size(), end = file.find('/', begin);
  return end == std::string::npos ? std::string() : file.substr(begin, end - begin);
}

bool ModuleDescription::add(const char* representation, ModuleInput::Kind kind,
                            void (*bind)(Module&, const Representation*)) {
  inputs.push_back({representation, kind, bind});
  return true;
}

bool ModuleDescription::add(const RepresentationLoader& representation,
                            void (*update)(Module&, Representation&)) {
  outputs.push_back({&representation, update});
  return true;
}

bool ModuleDescription::addAll(const char* representationKind, ModuleInput::Kind kind,
                               void (*bind)(Module&, const Representation*)) {
  inputsOfKinds.push_back({representationKind, kind, bind});
  return true;
}

const ModuleOutput* ModuleDescription::output(const std::string& representation) const {
  for (const ModuleOutput& output : outputs) {
    if (output.representation->name() == representation) return &output;
  }
  return nullptr;
}

}  // namespace plumbline
