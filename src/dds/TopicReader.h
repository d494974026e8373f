#pragma once
#include <memory>
#include <string>

#include "dds/Content.h"
#include "dds/DdsParticipant.h"

namespace plumbline::dds {

/// The name of a topic, for readers and writers.
struct TopicName {
  std::string topic;
  std::string type;
  bool bare = false;      ///< see BytesType
  bool reliable = false;  ///< lost samples are sent again, to readers that ask for it
  bool lasting = false;   ///< a reader who comes later gets the last sample
};

/// Takes arriving samples one at a time, in threads of the network. No call may throw.
class Arrivals {
public:
  /// The content into which the next sample is read.
  virtual Content& place() noexcept = 0;
  /// It was read.
  virtual void arrived() noexcept = 0;

protected:
  ~Arrivals() = default;
};

/// Reads samples of one topic as they arrive; only the newest of those that wait is kept.
class TopicReader {
public:
  /// `arrivals` outlives this. Throws std::runtime_error that names the topic.
  TopicReader(DdsParticipant& participant, const TopicName& name, Arrivals& arrivals);
  ~TopicReader();
  TopicReader(const TopicReader&) = delete;
  TopicReader& operator=(const TopicReader&) = delete;

  /// How many writers there are now; any thread.
  int writers() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace plumbline::dds
