#include "dds/NetworkOptions.h"

#include <algorithm>
#include <cctype>

#include "framework/ConfigurationError.h"

namespace plumbline::dds {
namespace {

constexpr std::size_t maxName = 64;
const char* const fileName = "NetworkModule";

std::string agentName(const ConfigSection& section, const char* key) {
  const auto name = section.get<std::string>(key);
  const bool good = std::all_of(name.begin(), name.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (!good || name.size() > maxName)
    section.fail(key, "is no name of an agent: up to 64 letters, digits, _ and -");
  return name;
}

}  // namespace

NetworkOptions readNetworkOptions(ConfigStore& config) {
  const ConfigSection& section = config.file(fileName).root();
  NetworkOptions options;
  options.agent = agentName(section, "agent");
  options.from = agentName(section, "from");
  if (options.agent.empty())
    section.fail("agent", "is empty; give the name under which others find this agent");
  options.participant.domain = section.get<unsigned>("domain", {0, 232});
  options.participant.addresses = section.get<std::vector<std::string>>("addresses");
  options.participant.peers = section.get<std::vector<std::string>>("peers");
  options.participant.token = section.get<std::string>("token");
  return options;
}

}  // namespace plumbline::dds
