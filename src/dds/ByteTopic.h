#pragma once
#include <memory>
#include <string>

#include "dds/BytesType.h"
#include "dds/Participant.h"

namespace plumbline::dds {

/// What a topic is called, for readers and writers.
struct TopicName {
  std::string topic;
  std::string type;
  bool bare = false;      ///< see BytesType
  bool reliable = false;  ///< lost samples are sent again, to readers that ask for it
  bool lasting = false;   ///< a reader who comes later gets the last sample
};

/// Writes samples of one topic; only the newest is kept, nobody waits for a slow reader.
class ByteWriter {
public:
  /// Throws std::runtime_error that names the topic.
  ByteWriter(Participant& participant, const TopicName& name);
  ~ByteWriter();
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  /// Any thread, one at a time. False: it was not sent.
  bool write(Sample& sample);
  /// How many readers there are now; any thread.
  int readers() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Keeps the newest sample of one topic.
class ByteReader {
public:
  /// Throws std::runtime_error that names the topic.
  ByteReader(Participant& participant, const TopicName& name);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Swaps the newest sample into `sample`; false if none came since the last call. Never waits.
  bool take(Sample& sample);
  /// How many writers there are now; any thread.
  int writers() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace plumbline::dds
