#pragma once
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "web/Broadcast.h"

namespace plumbline::web {

// A recorded match: what was sent to the pages and when. The format is in doc/reference/match-file.md.

struct MatchRecord {
  double time = 0;  ///< since the start of the recording [s]
  Channel channel = Channel::frame;
  std::string message;
  bool operator==(const MatchRecord&) const = default;
};

/// Appends to a file in chunks of two seconds, each readable by itself: what breaks off a recording costs the
/// last chunk only.
class MatchWriter {
public:
  /// Throws std::runtime_error, one line, if the file exists or cannot be written.
  explicit MatchWriter(const std::string& file);
  ~MatchWriter();
  MatchWriter(const MatchWriter&) = delete;
  MatchWriter& operator=(const MatchWriter&) = delete;

  /// time must not fall. Throws std::runtime_error if the disk is full or the file went away.
  void add(double time, Channel channel, const std::string& message);
  void flush();

private:
  void append(double time, Channel channel, const std::string& message);

  std::string name_;
  std::ofstream out_;
  std::array<std::string, numChannels> last_;  ///< what a chunk begins with
  std::string chunk_, frameBefore_;
  double begin_ = 0, end_ = 0;
};

/// Reads what MatchWriter wrote. Chunks are unpacked one at a time; a file's lengths are bounded before
/// memory is taken.
class MatchReader {
public:
  /// Throws std::runtime_error, one line, if it is no match file. A chunk cut off at the end is left out.
  explicit MatchReader(const std::string& file);

  double duration() const { return chunks_.empty() ? 0 : chunks_.back().end; }
  std::size_t numChunks() const { return chunks_.size(); }
  double beginOf(std::size_t chunk) const { return chunks_.at(chunk).begin; }
  double endOf(std::size_t chunk) const { return chunks_.at(chunk).end; }
  /// The chunk that holds a time, the nearest if none does.
  std::size_t chunkAt(double time) const;
  /// The records of a chunk in their order; the first ones repeat what was valid before, so a chunk alone is
  /// enough to show its times. Throws std::runtime_error if it is broken.
  std::vector<MatchRecord> read(std::size_t chunk);

private:
  struct Chunk {
    std::streamoff place = 0;
    std::uint32_t packed = 0, unpacked = 0;
    double begin = 0, end = 0;
  };
  [[noreturn]] void fail(const std::string& why) const;

  std::string name_;
  std::ifstream in_;
  std::vector<Chunk> chunks_;
};

}  // namespace plumbline::web
