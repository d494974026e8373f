#include "simspark/Framing.h"

namespace plumbline::simspark {

void appendFrameHeader(std::string& out, std::size_t length) {
  const auto n = static_cast<std::uint32_t>(length);
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>((n >> shift) & 0xff);
}

void appendFrame(std::string& out, std::string_view text) {
  appendFrameHeader(out, text.size());
  out += text;
}

void FrameReader::feed(std::string_view bytes) {
  if (broken) return;
  if (begin > 0) {
    buffer.erase(0, begin);
    begin = 0;
  }
  buffer += bytes;
}

FrameReader::Status FrameReader::next(std::string_view& message) {
  if (broken) return Status::tooLong;
  if (buffer.size() - begin < frameHeaderSize) return Status::incomplete;
  length = 0;
  for (std::size_t i = 0; i < frameHeaderSize; ++i)
    length = length << 8 | static_cast<std::uint8_t>(buffer[begin + i]);
  if (length > limit) {
    broken = true;
    return Status::tooLong;
  }
  if (buffer.size() - begin - frameHeaderSize < length) return Status::incomplete;
  message = std::string_view(buffer).substr(begin + frameHeaderSize, length);
  begin += frameHeaderSize + length;
  return Status::message;
}

void FrameReader::reset() {
  buffer.clear();
  begin = 0;
  broken = false;
}

}  // namespace plumbline::simspark
