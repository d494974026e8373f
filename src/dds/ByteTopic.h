#pragma once
#include <memory>
#include <string>

#include "dds/Newest.h"
#include "dds/TopicReader.h"

namespace plumbline::dds {

/// The number of the sender's cycle and the bytes of a message.
struct Sample {
  std::uint64_t cycle = 0;
  std::string bytes;
};

/// Writes samples of one topic; only the newest is kept, nobody waits for a slow reader.
class ByteWriter {
public:
  /// Throws std::runtime_error that names the topic.
  ByteWriter(DdsParticipant& participant, const TopicName& name);
  ~ByteWriter();
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  /// Any thread, one at a time. False: it was not sent.
  bool write(const Content& content);
  bool write(const Sample& sample);
  /// How many readers there are now; any thread.
  int readers() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Keeps the newest sample of one topic.
class ByteReader : Arrivals {
public:
  /// Throws std::runtime_error that names the topic.
  ByteReader(DdsParticipant& participant, const TopicName& name) : reader_(participant, name, *this) {}
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Swaps the newest sample into `sample`; false if none came since the last call. Never waits.
  bool take(Sample& sample);
  /// How many writers there are now; any thread.
  int writers() const { return reader_.writers(); }

private:
  Content& place() noexcept override { return newest_.writing(); }
  void arrived() noexcept override { newest_.publish(); }

  Newest<BytesContent> newest_;
  TopicReader reader_;  ///< last, so that it is destroyed before newest_, which it fills
};

}  // namespace plumbline::dds
