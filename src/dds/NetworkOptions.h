#pragma once
#include <string>
#include <vector>

#include "dds/DdsParticipant.h"
#include "framework/ConfigFile.h"
#include "parameters/Parameter.h"

namespace plumbline::dds {

/// config/NetworkModule.yaml: under which name this agent shows its representations, and whose it reads.
struct NetworkOptions {
  PARAMETERS(NetworkOptions)
  PARAMETER(std::string, agent, "agent", "", Range(),
            "under this name others find this agent: up to 64 letters, digits, _ and -")
  PARAMETER(std::string, from, "agent", "", Range(),
            "whose representations the lines `network Name` fetch; empty: nobody's")
  PARAMETER(unsigned, domain, ParticipantOptions().domain, "", Range(0, 232),
            "agents of two domains never meet")
  PARAMETER(std::vector<std::string>, addresses, ParticipantOptions().addresses, "", Range(),
            "of this machine, IPv4; any other than the loopback's wants a token")
  PARAMETER(std::vector<std::string>, peers, {}, "", Range(),
            "machines, IPv4, that are asked where no multicast reaches them")
  PARAMETER(std::string, token, "", "", Range(), "agents with another one neither show nor see")

  ParticipantOptions participant() const {
    return {.domain = domain, .addresses = addresses, .peers = peers, .token = token};
  }
};

/// Throws ConfigurationError.
NetworkOptions readNetworkOptions(ConfigStore& config);

}  // namespace plumbline::dds
