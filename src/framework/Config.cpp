#include "framework/Config.h"

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline {

const ConfigSection& Config::file(const std::string& name) const { return store_.file(name, name_).root(); }

void Config::refuse(const std::string& key, const std::string& message) const {
  // Not as a reader: a module that checks its parameters need not read the file itself.
  if (exists(name_) && store_.file(name_).root().has(key)) store_.file(name_).root().fail(key, message);
  throw ConfigurationError(name_ + "." + key + " " + message);
}

bool Config::exists(const std::string& name) const { return store_.exists(name); }
const std::vector<std::string>& Config::directories() const { return store_.directories(); }

}  // namespace plumbline
