#include "framework/Config.h"

#include "framework/ConfigFile.h"

namespace plumbline {

const ConfigSection& Config::file(const std::string& name) const { return store_.file(name).root(); }
bool Config::exists(const std::string& name) const { return store_.exists(name); }
const std::vector<std::string>& Config::directories() const { return store_.directories(); }

}  // namespace plumbline
