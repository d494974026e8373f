#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dds/ByteTopic.h"
#include "dds/NetworkOptions.h"
#include "dds/SendingThread.h"
#include "framework/Log.h"
#include "framework/RepresentationLoader.h"
#include "framework/ThreadCopy.h"

namespace plumbline::dds {

/// A representation that this agent shows. Its thread copies it at the end of a cycle if somebody reads it;
/// the hub's own thread makes bytes of the copy and sends them.
class SentRepresentation {
public:
  SentRepresentation(Participant& participant, const NetworkOptions& options,
                     const RepresentationLoader& loader, const Representation& source);

  bool wanted() const { return writer_.readers() > 0; }
  /// In the thread of the source, after each cycle.
  void publish() { copy_.publish(); }
  /// In the thread that sends; does nothing if nothing new was published.
  void send();

private:
  std::unique_ptr<RepresentationHolder> sent_;
  std::uint64_t shape_;
  ThreadCopy copy_;
  ByteWriter writer_;
  Sample sample_;
};

/// A representation that another agent shows.
class ReceivedRepresentation {
public:
  ReceivedRepresentation(Participant& participant, const NetworkOptions& options,
                         const RepresentationLoader& loader, Representation& target);

  /// In the thread of the target, before each cycle: the newest value, if one came. What cannot be read, is
  /// of another shape or not finite changes nothing and is told to the log.
  void receive(Log& log);

private:
  bool read();

  const RepresentationLoader& loader_;
  Representation& target_;
  std::string from_;
  std::unique_ptr<RepresentationHolder> scratch_;
  std::uint64_t shape_;
  ByteReader reader_;
  Sample sample_;
  int writers_ = 0;
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
  std::unique_ptr<Participant> participant_;
  std::map<std::string, std::unique_ptr<SentRepresentation>> sent_;
  SendingThread thread_{[this] { send(); }};  ///< ends before what it sends
};

}  // namespace plumbline::dds
