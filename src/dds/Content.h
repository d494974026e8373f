#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace plumbline::dds {

/// What one sample carries, on its way to the wire or from it.
class Content {
public:
  virtual ~Content() = default;
  /// Bytes that write() needs.
  virtual std::size_t size() const = 0;
  /// Fills `size` bytes; false: it cannot be sent.
  virtual bool write(char* memory, std::size_t size) const = 0;
  /// `bytes` are valid during the call.
  virtual void read(std::string_view bytes) = 0;

  std::uint64_t cycle = 0;  ///< number of the sender's cycle
};

/// The bytes of a message.
class BytesContent final : public Content {
public:
  std::size_t size() const override { return bytes.size(); }
  bool write(char* memory, std::size_t size) const override { return bytes.copy(memory, size) == size; }
  void read(std::string_view from) override { bytes.assign(from); }

  std::string bytes;
};

}  // namespace plumbline::dds
