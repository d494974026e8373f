#include "dds/NetworkOptions.h"

#include <algorithm>
#include <cctype>

#include "framework/ConfigurationError.h"
#include "framework/ModuleParameters.h"
#include "framework/ParameterFiles.h"

namespace plumbline::dds {

MAKE_PARAMETER_FILE("NetworkModule", NetworkOptions,
                    "Representations between agents: who this agent is, and whom it reads.")

namespace {

constexpr std::size_t maxName = 64;
const char* const fileName = "NetworkModule";

void checkName(const ConfigSection& section, const char* key, const std::string& name) {
  const bool good = std::all_of(name.begin(), name.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (!good || name.size() > maxName)
    section.fail(key, "is no name of an agent: up to 64 letters, digits, _ and -");
}

}  // namespace

NetworkOptions readNetworkOptions(ConfigStore& config) {
  NetworkOptions options;
  if (!config.exists(fileName)) return options;
  const ConfigSection& section = config.file(fileName).root();
  readParameters(section, NetworkOptions::parameterList(), &options);
  checkName(section, "agent", options.agent);
  checkName(section, "from", options.from);
  if (options.agent.empty())
    section.fail("agent", "is empty; give the name under which others find this agent");
  return options;
}

}  // namespace plumbline::dds
