#include "dds/RepresentationContent.h"

#include <cstring>
#include <exception>

#include "dds/StreamShape.h"
#include "framework/BinaryStream.h"

namespace plumbline::dds {

RepresentationContent::RepresentationContent(const RepresentationLoader& loader)
    : loader_(loader), holder_(loader.create()), shape_(shapeOf(holder_->get())) {}

std::size_t RepresentationContent::size() const {
  BinaryOut<CountingSink> out;
  holder_->get().stream(nullptr, &out);
  return sizeof shape_ + out.sink().size();
}

bool RepresentationContent::write(char* memory, std::size_t size) const {
  if (size < sizeof shape_) return false;
  std::memcpy(memory, &shape_, sizeof shape_);
  BinaryOut<MemorySink> out(memory + sizeof shape_, size - sizeof shape_);
  holder_->get().stream(nullptr, &out);
  return !out.sink().full() && out.sink().left() == 0;
}

std::string RepresentationContent::readValue(std::string_view bytes) {
  std::uint64_t shape = 0;
  if (bytes.size() >= sizeof shape) std::memcpy(&shape, bytes.data(), sizeof shape);
  if (shape != shape_) return "its members are others than here: are both programs of one version?";
  BinaryInStream in(bytes.substr(sizeof shape));
  value().stream(&in, nullptr);
  if (in.ok() && !in.atEnd()) in.fail("bytes left over");
  return in.ok() ? loader_.problemOf(value()) : in.error();
}

void RepresentationContent::read(std::string_view bytes) {
  try {
    try {
      problem_ = readValue(bytes);
    } catch (const std::exception& error) {  // a value may have to look something up
      problem_ = error.what();
      if (problem_.empty()) problem_ = "it cannot be read";
    }
    // The next sample must not complete half of this value.
    if (!problem_.empty()) holder_ = loader_.create();
  } catch (const std::exception&) {
    problem_ = "no memory";  // short enough to need none
  }
}

}  // namespace plumbline::dds
