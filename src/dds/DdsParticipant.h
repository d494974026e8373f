#pragma once
#include <memory>
#include <string>
#include <vector>

namespace eprosima::fastdds::dds {
class DomainParticipant;
class Publisher;
class Subscriber;
}  // namespace eprosima::fastdds::dds

namespace plumbline::dds {

/// Which other participants a participant sees.
struct ParticipantOptions {
  unsigned domain = 0;  ///< 0 to 232: participants of two domains never meet
  /// Addresses of this machine, IPv4, that it uses. Any other than the loopback's needs a token.
  std::vector<std::string> addresses = {"127.0.0.1"};
  /// Machines, IPv4, that multicast does not reach.
  std::vector<std::string> peers;
  /// Participants with another token neither read nor are read. It separates agents but does not encrypt.
  std::string token;
  /// Readers and writers without the token's partition as well, for programs of others (ROS 2).
  bool open = false;
};

/// One participant of DDS (Fast DDS): this process among the others. Samples go over shared memory within a
/// machine and over UDP between machines. Throws std::runtime_error that says what is wrong with the options
/// or what could not be opened.
class DdsParticipant {
public:
  explicit DdsParticipant(const ParticipantOptions& options);
  ~DdsParticipant();
  DdsParticipant(const DdsParticipant&) = delete;
  DdsParticipant& operator=(const DdsParticipant&) = delete;

  eprosima::fastdds::dds::DomainParticipant& get() { return *participant_; }
  eprosima::fastdds::dds::Publisher& publisher() { return *publisher_; }
  eprosima::fastdds::dds::Subscriber& subscriber() { return *subscriber_; }

private:
  void close();

  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
};

}  // namespace plumbline::dds
