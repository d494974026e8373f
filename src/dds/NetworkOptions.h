#pragma once
#include <string>

#include "dds/DdsParticipant.h"
#include "framework/ConfigFile.h"

namespace plumbline::dds {

/// config/NetworkModule.yaml: under which name this agent shows its representations, and whose it reads.
struct NetworkOptions {
  std::string agent;  ///< letters, digits, _ and -
  std::string from;   ///< the same; needed only if modules.cfg has a line `network Representation`
  ParticipantOptions participant;
};

/// Throws ConfigurationError.
NetworkOptions readNetworkOptions(ConfigStore& config);

}  // namespace plumbline::dds
