#pragma once
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "dds/ByteTopic.h"
#include "dds/NetworkOptions.h"
#include "dds/Newest.h"
#include "dds/RepresentationContent.h"
#include "dds/SendingThread.h"
#include "framework/Log.h"
#include "framework/RepresentationLoader.h"
#include "framework/ThreadCopy.h"

namespace plumbline::dds {

/// A representation that this agent shows. Its thread copies it at the end of a cycle if somebody reads it;
/// the hub's own thread makes bytes of the copy and sends them.
class SentRepresentation {
public:
  SentRepresentation(DdsParticipant& participant, const NetworkOptions& options,
                     const RepresentationLoader& loader, const Representation& source);

  bool wanted() const { return writer_.readers() > 0; }
  /// In the thread of the source, after each cycle.
  void publish() { copy_.publish(); }
  /// In the thread that sends; does nothing if nothing new was published.
  void send();

private:
  RepresentationContent sent_;
  ThreadCopy copy_;
  ByteWriter writer_;
};

/// A representation that another agent sends. Samples are read and checked in the network's thread. A sample
/// that cannot be read, has other members, or has a value that no module may provide, changes nothing.
class ReceivedRepresentation : Arrivals {
public:
  /// `whenArrived` is called in the network's thread with each good value.
  ReceivedRepresentation(DdsParticipant& participant, const NetworkOptions& options,
                         const RepresentationLoader& loader, Representation& target,
                         std::function<void(const Representation&)> whenArrived = nullptr);
  ReceivedRepresentation(const ReceivedRepresentation&) = delete;
  ReceivedRepresentation& operator=(const ReceivedRepresentation&) = delete;

  /// In the thread of the target, before each cycle: the newest value, if one came. Says what changed and
  /// what was wrong since the last call.
  void receive(Log& log);

private:
  Content& place() noexcept override { return newest_.writing(); }
  void arrived() noexcept override;

  const RepresentationLoader& loader_;
  Representation& target_;
  std::string from_;
  std::function<void(const Representation&)> whenArrived_;
  Newest<RepresentationContent> newest_;
  std::mutex mutex_;
  std::string problem_;             ///< of the last one that was left out; under the mutex
  std::atomic<bool> wrong_{false};  ///< there is a problem that was not reported
  int writers_ = 0;
  TopicReader reader_;  ///< ends before what it fills
};

/// The network of an agent: one participant and one thread that sends, whatever number of threads names
/// `network` in modules.cfg.
class NetworkHub {
public:
  /// By the first thread; later calls do nothing. Throws ConfigurationError.
  void open(ConfigStore& config);

  /// Before the first cycle; throw ConfigurationError. A representation that several threads have is shown by
  /// the first of them: the others get null.
  SentRepresentation* show(const RepresentationLoader& loader, const Representation& source);
  std::unique_ptr<ReceivedRepresentation> receive(const RepresentationLoader& loader, Representation& target);
  /// Something was published.
  void wake() { thread_.wake(); }

private:
  void send();

  NetworkOptions options_;
  std::unique_ptr<DdsParticipant> participant_;
  std::map<std::string, std::unique_ptr<SentRepresentation>> sent_;
  SendingThread thread_{[this] { send(); }};  ///< ends before what it sends
};

}  // namespace plumbline::dds
