#include "dds/DdsParticipant.h"

#include <arpa/inet.h>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <mutex>
#include <stdexcept>

#include "dds/LeftMemory.h"
#include "math/Fingerprint.h"

namespace plumbline::dds {
namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
namespace {

constexpr unsigned maxDomain = 232, maxPeers = 64;
constexpr std::uint32_t sharedMemory = 8u << 20;  ///< bytes on their way to readers of this machine
/// After this time without a sign, a reader of shared memory counts as dead; if it comes back, it gets a new
/// place [ms].
constexpr std::uint32_t deadReader = 100;
/// Bytes that the system keeps for our slow threads; it may give less.
constexpr std::uint32_t socketBuffer = 4u << 20;

std::uint32_t addressOf(const std::string& text, const char* what) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1)
    throw std::runtime_error(std::string(what) + " \"" + text + "\" is no IPv4 address, as 192.168.1.5 is");
  return ntohl(address.s_addr);
}

bool isLoopback(std::uint32_t address) { return address >> 24 == 127; }

void check(const ParticipantOptions& options) {
  if (options.domain > maxDomain)
    throw std::runtime_error("domain " + std::to_string(options.domain) + " is not within 0 to 232");
  if (options.addresses.empty())
    throw std::runtime_error("addresses is empty; give 127.0.0.1 or one of this machine");
  if (options.peers.size() > maxPeers) throw std::runtime_error("more than 64 peers");
  for (const std::string& peer : options.peers) addressOf(peer, "peer");
  for (const std::string& address : options.addresses) {
    if (!isLoopback(addressOf(address, "address")) && options.token.empty() && !options.open)
      throw std::runtime_error("address " + address + " shows the agent to others: set a token");
  }
}

/// Announcements: soon after the start, and often enough that a returning participant is found within 2 s.
void setDiscovery(fast::DomainParticipantQos& qos, const ParticipantOptions& options) {
  auto& discovery = qos.wire_protocol().builtin.discovery_config;
  discovery.leaseDuration = {5, 0};
  discovery.leaseDuration_announcementperiod = {1, 0};
  discovery.initial_announcements.count = 10;
  discovery.initial_announcements.period = {0, 100'000'000};
  // Participants announce themselves by UDP only: a killed reader leaves shared memory behind, and its
  // successor would have to wait for that memory.
  auto& builtin = qos.wire_protocol().builtin;
  constexpr std::uint32_t firstPort = 7400, portsOfADomain = 250;
  rtps::Locator_t group;
  group.kind = LOCATOR_KIND_UDPv4;
  group.port = firstPort + portsOfADomain * options.domain;
  rtps::IPLocator::setIPv4(group, "239.255.0.1");
  builtin.metatrafficMulticastLocatorList.push_back(group);
  for (const std::string& address : options.addresses) {
    rtps::Locator_t own;
    own.kind = LOCATOR_KIND_UDPv4;
    own.port = 0;  // the first that is free
    rtps::IPLocator::setIPv4(own, address);
    builtin.metatrafficUnicastLocatorList.push_back(own);
  }
  for (const std::string& peer : options.peers) {
    rtps::Locator_t locator;
    locator.kind = LOCATOR_KIND_UDPv4;
    rtps::IPLocator::setIPv4(locator, peer);
    qos.wire_protocol().builtin.initialPeersList.push_back(locator);
  }
  if (!options.peers.empty()) {  // who gives peers still sees this machine and what multicast reaches
    for (const char* address : {"239.255.0.1", "127.0.0.1"}) {
      rtps::Locator_t locator;
      locator.kind = LOCATOR_KIND_UDPv4;
      rtps::IPLocator::setIPv4(locator, address);
      qos.wire_protocol().builtin.initialPeersList.push_back(locator);
    }
  }
}

void setTransports(fast::DomainParticipantQos& qos, const ParticipantOptions& options) {
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = options.addresses;
  udp->sendBufferSize = udp->receiveBufferSize = socketBuffer;
  udp->non_blocking_send = true;  // a full socket loses a sample, which the next one makes good
  auto memory = std::make_shared<eprosima::fastdds::rtps::SharedMemTransportDescriptor>();
  memory->segment_size(sharedMemory);
  memory->healthy_check_timeout_ms(deadReader);
  qos.transport().user_transports = {memory, udp};
}

/// The DDS partition: only participants of one partition connect. It shows only a hash of the token.
std::string partitionOf(const std::string& token) {
  Fingerprint hash;
  for (const char c : token) hash.add(static_cast<unsigned char>(c));
  return "plumbline-" + std::to_string(hash.value());
}

}  // namespace

DdsParticipant::DdsParticipant(const ParticipantOptions& options) {
  check(options);
  fast::Log::SetVerbosity(fast::Log::Kind::Error);
  fast::DomainParticipantQos qos;
  qos.name("plumbline");
  setDiscovery(qos, options);
  setTransports(qos, options);
  static std::once_flag cleared;
  std::call_once(cleared, [] { removeLeftMemory(); });
  auto* factory = fast::DomainParticipantFactory::get_instance();
  participant_ = factory->create_participant(options.domain, qos);
  if (!participant_)
    throw std::runtime_error("DDS does not start on domain " + std::to_string(options.domain));
  auto publisher = participant_->get_default_publisher_qos();
  auto subscriber = participant_->get_default_subscriber_qos();
  if (!options.open) {
    publisher.partition().push_back(partitionOf(options.token).c_str());
    subscriber.partition().push_back(partitionOf(options.token).c_str());
  }
  publisher_ = participant_->create_publisher(publisher);
  subscriber_ = participant_->create_subscriber(subscriber);
  if (!publisher_ || !subscriber_) {
    close();
    throw std::runtime_error("DDS gives neither publisher nor subscriber");
  }
}

DdsParticipant::~DdsParticipant() { close(); }

void DdsParticipant::close() {
  participant_->delete_contained_entities();
  fast::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

}  // namespace plumbline::dds
