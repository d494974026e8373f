#pragma once
#include <map>
#include <memory>
#include <string>

#include "parameters/Parameter.h"

namespace plumbline {

/// A configuration file that is no module's: config/<name>.yaml has values of one struct of PARAMETERS.
struct ParameterFile {
  std::string comment;  ///< one sentence: what it is about
  const ParameterList* parameters;
  std::shared_ptr<void> (*make)();  ///< an owner with the defaults
};

/// All that this program's folders registered, by name.
class ParameterFiles {
public:
  static std::map<std::string, ParameterFile>& all();
  static bool add(const std::string& name, ParameterFile file) { return all().emplace(name, file).second; }
};

}  // namespace plumbline

/// In the .cpp that reads the file: MAKE_PARAMETER_FILE("field", FieldSize, "The sizes of a soccer field.");
#define MAKE_PARAMETER_FILE(name, Owner, comment)                                               \
  [[maybe_unused]] static const bool plumblineFileOf##Owner = ::plumbline::ParameterFiles::add( \
      name, {comment, &Owner::parameterList(),                                                  \
             []() -> std::shared_ptr<void> { return std::make_shared<Owner>(); }});
