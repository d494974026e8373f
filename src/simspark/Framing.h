#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::simspark {

// A message on the wire is its length as four bytes, most significant first, and then its text.
constexpr std::size_t frameHeaderSize = 4;
constexpr std::size_t maxServerMessage =
    1u << 22;  ///< bytes a client accepts: a scene with 22 robots has 0.1 MB
constexpr std::size_t maxAgentMessage = 1u << 16;  ///< bytes the simulator accepts from an agent or trainer

/// Appends the header of a message of so many bytes.
void appendFrameHeader(std::string& out, std::size_t length);
/// Appends a message with its header.
void appendFrame(std::string& out, std::string_view text);

/// Cuts a stream of bytes into messages. Memory grows with the bytes that came, never with the length
/// announced.
class FrameReader {
public:
  enum class Status { message, incomplete, tooLong };

  explicit FrameReader(std::size_t maxMessage) : limit_(maxMessage) {}

  void feed(std::string_view bytes);
  /// The next whole message, valid until the next feed. A length above the limit makes the stream useless:
  /// tooLong from then on, and announced() is the length.
  Status next(std::string_view& message);

  bool empty() const { return begin_ == buffer_.size(); }  ///< nothing half received
  std::uint32_t announced() const { return length_; }
  void reset();

private:
  std::size_t limit_;
  std::string buffer_;
  std::size_t begin_ = 0;
  std::uint32_t length_ = 0;
  bool broken_ = false;
};

}  // namespace plumbline::simspark
