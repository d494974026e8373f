#include "web/MatchFile.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace plumbline::web {

static_assert(std::endian::native == std::endian::little, "match files are written as they lie in memory");

namespace {

constexpr std::string_view magic = "PLUMBLINE MATCH\n";
constexpr std::uint32_t formatVersion = 1, chunkMark = 0x4b4e4843;  // "CHNK"
constexpr double chunkSeconds = 2;
constexpr std::size_t fullChunk = 4u << 20, maxChunk = 64u << 20;  ///< bytes unpacked
constexpr std::uint8_t differenceFlag = 0x80;

struct ChunkHeader {
  std::uint32_t mark = chunkMark, packed = 0, unpacked = 0, reserved = 0;
  double begin = 0, end = 0;
};
static_assert(sizeof(ChunkHeader) == 32);

struct RecordHeader {
  std::uint32_t milliseconds = 0, length = 0;  ///< since the chunk's begin
};

/// Byte by byte: two frames of a game differ little.
void subtract(std::string& bytes, const std::string& before) {
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(bytes[i] - before[i]);
}
void add(std::string& bytes, const std::string& before) {
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(bytes[i] + before[i]);
}

}  // namespace

MatchWriter::MatchWriter(const std::string& file) : name_(file) {
  if (std::filesystem::exists(file))
    throw std::runtime_error(file + ": there is such a file already; remove it or record to another");
  out_.open(file, std::ios::binary);
  out_.write(magic.data(), static_cast<std::streamsize>(magic.size()));
  out_.write(reinterpret_cast<const char*>(&formatVersion), sizeof formatVersion);
  out_.flush();
  if (!out_) throw std::runtime_error(file + ": cannot write it");
}

MatchWriter::~MatchWriter() {
  try {
    flush();
  } catch (const std::exception&) {  // it has been said before, or nobody is left to hear it
  }
}

// A whole record or none, also where memory ends.
void MatchWriter::append(double time, Channel channel, const std::string& message) {
  const bool difference =
      channel == Channel::frame && !message.empty() && message.size() == frameBefore_.size();
  const RecordHeader header{static_cast<std::uint32_t>(std::lround((time - begin_) * 1000)),
                            static_cast<std::uint32_t>(message.size())};
  std::string record(
      1, static_cast<char>(static_cast<std::uint8_t>(channel) | (difference ? differenceFlag : 0)));
  record.append(reinterpret_cast<const char*>(&header), sizeof header);
  std::string bytes = message;
  if (difference) subtract(bytes, frameBefore_);
  record += bytes;
  if (channel == Channel::frame) bytes = message;
  chunk_ += record;
  if (channel == Channel::frame) frameBefore_.swap(bytes);
}

void MatchWriter::add(double time, Channel channel, const std::string& message) {
  if (message.size() > fullChunk) return;  // no message is so long
  if (!chunk_.empty() && (time >= begin_ + chunkSeconds || chunk_.size() > fullChunk)) flush();
  if (chunk_.empty()) {
    begin_ = end_ = time;
    for (std::size_t i = 0; i < numChannels; ++i)
      if (!last_[i].empty() && static_cast<Channel>(i) != channel)
        append(time, static_cast<Channel>(i), last_[i]);
  }
  append(time, channel, message);
  end_ = time;
  last_[static_cast<std::size_t>(channel)] = message;
}

void MatchWriter::flush() {
  if (chunk_.empty()) return;
  uLongf packedSize = compressBound(chunk_.size());
  std::string packed(packedSize, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &packedSize,
                reinterpret_cast<const Bytef*>(chunk_.data()), chunk_.size(), 3) != Z_OK)
    throw std::runtime_error(name_ + ": cannot pack a chunk");
  ChunkHeader header;
  header.packed = static_cast<std::uint32_t>(packedSize);
  header.unpacked = static_cast<std::uint32_t>(chunk_.size());
  header.begin = begin_;
  header.end = end_;
  chunk_.clear();
  frameBefore_.clear();
  out_.write(reinterpret_cast<const char*>(&header), sizeof header);
  out_.write(packed.data(), static_cast<std::streamsize>(packedSize));
  out_.flush();
  if (!out_) throw std::runtime_error(name_ + ": cannot write on; is the disk full?");
}

void MatchReader::fail(const std::string& why) const { throw std::runtime_error(name_ + ": " + why); }

MatchReader::MatchReader(const std::string& file) : name_(file), in_(file, std::ios::binary | std::ios::ate) {
  if (!in_) fail("cannot read it");
  const std::streamoff size = in_.tellg();
  in_.seekg(0);
  std::string begin(magic.size(), '\0');
  std::uint32_t version = 0;
  in_.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  in_.read(reinterpret_cast<char*>(&version), sizeof version);
  if (!in_ || begin != magic) fail("no match file");
  if (version != formatVersion)
    fail("a match file of version " + std::to_string(version) + "; this program reads " +
         std::to_string(formatVersion));
  std::streamoff place = in_.tellg();
  while (size - place >= static_cast<std::streamoff>(sizeof(ChunkHeader))) {
    ChunkHeader header;
    in_.seekg(place);
    in_.read(reinterpret_cast<char*>(&header), sizeof header);
    place += static_cast<std::streamoff>(sizeof header);
    const double before = chunks_.empty() ? 0 : chunks_.back().end;
    if (!in_ || header.mark != chunkMark || header.packed > maxChunk || header.unpacked > maxChunk ||
        !(header.begin >= before) || !(header.end >= header.begin) || !std::isfinite(header.end))
      fail("broken at byte " + std::to_string(place - static_cast<std::streamoff>(sizeof header)));
    if (header.packed > size - place) break;  // the recording broke off here
    chunks_.push_back({place, header.packed, header.unpacked, header.begin, header.end});
    place += header.packed;
  }
  if (chunks_.empty()) fail("nothing is recorded in it");
}

std::size_t MatchReader::chunkAt(double time) const {
  const auto after = std::upper_bound(chunks_.begin(), chunks_.end(), time,
                                      [](double t, const Chunk& chunk) { return t < chunk.begin; });
  return after == chunks_.begin() ? 0 : static_cast<std::size_t>(after - chunks_.begin()) - 1;
}

std::vector<MatchRecord> MatchReader::read(std::size_t index) {
  const Chunk& chunk = chunks_.at(index);
  std::string packed(chunk.packed, '\0'), bytes(chunk.unpacked, '\0');
  in_.clear();
  in_.seekg(chunk.place);
  in_.read(packed.data(), static_cast<std::streamsize>(packed.size()));
  uLongf size = bytes.size();
  if (!in_ ||
      uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                 packed.size()) != Z_OK ||
      size != bytes.size())
    fail("broken in the chunk at byte " + std::to_string(chunk.place));

  std::vector<MatchRecord> records;
  std::string frameBefore;
  for (std::size_t place = 0; place < bytes.size();) {
    RecordHeader header;
    const auto code = static_cast<std::uint8_t>(bytes[place]);
    const std::size_t text = place + 1 + sizeof header;
    if (text <= bytes.size()) std::memcpy(&header, bytes.data() + place + 1, sizeof header);
    const auto channel = static_cast<std::size_t>(code & ~differenceFlag);
    if (text > bytes.size() || channel >= numChannels || header.length > bytes.size() - text)
      fail("a broken record in the chunk at byte " + std::to_string(chunk.place));
    MatchRecord record{chunk.begin + header.milliseconds / 1000.0, static_cast<Channel>(channel),
                       bytes.substr(text, header.length)};
    if ((code & differenceFlag) != 0) {
      if (record.message.size() != frameBefore.size())
        fail("a broken record in the chunk at byte " + std::to_string(chunk.place));
      web::add(record.message, frameBefore);
    }
    if (record.channel == Channel::frame) frameBefore = record.message;
    records.push_back(std::move(record));
    place = text + header.length;
  }
  return records;
}

}  // namespace plumbline::web
