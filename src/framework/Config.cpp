#include "framework/Config.h"

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline {

const ConfigSection& Config::file(const std::string& name) const { return store_.file(name).root(); }

void Config::refuse(const std::string& key, const std::string& message) const {
  if (exists(name_) && file(name_).has(key)) file(name_).fail(key, message);
  throw ConfigurationError(name_ + "." + key + " " + message);
}

bool Config::exists(const std::string& name) const { return store_.exists(name); }
const std::vector<std::string>& Config::directories() const { return store_.directories(); }

}  // namespace plumbline
