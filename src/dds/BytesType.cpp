#include "dds/BytesType.h"

#include <array>
#include <cstring>

namespace plumbline::dds {
namespace {

constexpr std::array<unsigned char, 4> littleEndian = {0, 1, 0, 0};  ///< CDR's header
constexpr std::size_t lengthSize = 4, cycleSize = 8;

std::size_t headSize(bool bare) { return littleEndian.size() + (bare ? 0 : cycleSize + lengthSize); }

}  // namespace

BytesType::BytesType(const std::string& name, bool bare) : bare_(bare) {
  setName(name.c_str());
  m_typeSize = 1024;  // grows with the sample
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool BytesType::serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) {
  const Content& content = *static_cast<Content*>(data);
  const std::size_t contentSize = content.size(), size = headSize(bare_) + contentSize;
  if (contentSize > maxBytes || payload->max_size < size) return false;
  unsigned char* at = payload->data;
  const auto put = [&](const void* from, std::size_t bytes) {
    std::memcpy(at, from, bytes);
    at += bytes;
  };
  put(littleEndian.data(), littleEndian.size());
  if (!bare_) {
    const auto length = static_cast<std::uint32_t>(contentSize);
    put(&content.cycle, cycleSize);
    put(&length, lengthSize);
  }
  if (!content.write(reinterpret_cast<char*>(at), contentSize)) return false;
  payload->encapsulation = CDR_LE;
  payload->length = static_cast<std::uint32_t>(size);
  return true;
}

bool BytesType::deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) {
  Content& content = *static_cast<Content*>(data);
  const std::size_t head = headSize(bare_);
  if (payload->length < head || std::memcmp(payload->data, littleEndian.data(), 2) != 0) return false;
  std::size_t size = payload->length - head;
  if (!bare_) {
    std::uint32_t length = 0;
    std::memcpy(&content.cycle, payload->data + littleEndian.size(), cycleSize);
    std::memcpy(&length, payload->data + littleEndian.size() + cycleSize, lengthSize);
    if (length > size) return false;
    size = length;  // the rest fills up to a multiple of four
  }
  if (size > maxBytes) return false;
  content.read({reinterpret_cast<const char*>(payload->data) + head, size});
  return true;
}

std::function<std::uint32_t()> BytesType::getSerializedSizeProvider(void* data) {
  const auto size = static_cast<std::uint32_t>(headSize(bare_) + static_cast<Content*>(data)->size());
  return [size] { return size; };
}

}  // namespace plumbline::dds
