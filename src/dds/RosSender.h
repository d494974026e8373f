#pragma once
#include <array>
#include <memory>
#include <string>

#include "dds/ByteTopic.h"
#include "dds/RosMessages.h"
#include "dds/SendingThread.h"

namespace plumbline::dds {

/// The messages that an agent sends to ROS 2.
enum class RosTopic { joints, inertial, odometry, frames, ball, description };

/// Sends messages of ROS 2 in a thread of its own; of a topic that is sent faster than the network takes it,
/// only the newest.
class RosSender {
public:
  /// Topics are /`prefix`joint_states and so on. Throws std::runtime_error.
  RosSender(const ParticipantOptions& options, const std::string& prefix);

  /// By one thread; the message goes out after the next wake().
  void send(RosTopic topic, std::string message);
  void wake() { thread_.wake(); }

private:
  struct Outgoing {
    std::unique_ptr<ByteWriter> writer;
    Newest<Sample> newest;
  };

  void sendAll();

  static constexpr std::size_t numTopics = 6;
  DdsParticipant participant_;
  std::array<Outgoing, numTopics> outgoing_;
  SendingThread thread_{[this] { sendAll(); }};  ///< ends before what it sends
};

}  // namespace plumbline::dds
