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
  if (broken_) return;
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    begin_ = 0;
  }
  buffer_ += bytes;
}

FrameReader::Status FrameReader::next(std::string_view& message) {
  if (broken_) return Status::tooLong;
  if (buffer_.size() - begin_ < frameHeaderSize) return Status::incomplete;
  length_ = 0;
  for (std::size_t i = 0; i < frameHeaderSize; ++i)
    length_ = length_ << 8 | static_cast<std::uint8_t>(buffer_[begin_ + i]);
  if (length_ > limit_) {
    broken_ = true;
    return Status::tooLong;
  }
  if (buffer_.size() - begin_ - frameHeaderSize < length_) return Status::incomplete;
  message = std::string_view(buffer_).substr(begin_ + frameHeaderSize, length_);
  begin_ += frameHeaderSize + length_;
  return Status::message;
}

void FrameReader::reset() {
  buffer_.clear();
  begin_ = 0;
  broken_ = false;
}

}  // namespace plumbline::simspark
