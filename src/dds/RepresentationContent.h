#pragma once
#include <memory>
#include <string>

#include "dds/Content.h"
#include "framework/RepresentationLoader.h"

namespace plumbline::dds {

/// A representation as the content of a sample: eight bytes for its shape, then its binary stream, written to
/// and read from the network's own memory, without a copy between. What is read must meet the same rules as
/// values of modules (RepresentationLoader::problemOf).
class RepresentationContent final : public Content {
public:
  explicit RepresentationContent(const RepresentationLoader& loader);

  Representation& value() { return holder_->get(); }
  /// "", or why the last bytes read are no value; then value() may be anything.
  const std::string& problem() const { return problem_; }

  std::size_t size() const override;
  bool write(char* memory, std::size_t size) const override;
  /// Throws nothing.
  void read(std::string_view bytes) override;

private:
  std::string readValue(std::string_view bytes);

  const RepresentationLoader& loader_;
  std::unique_ptr<RepresentationHolder> holder_;
  std::uint64_t shape_;
  std::string problem_;
};

}  // namespace plumbline::dds
