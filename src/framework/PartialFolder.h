#pragma once
#include <filesystem>

namespace plumbline {

/// A folder that is being written beside its place. It goes with this object, whatever was thrown meanwhile,
/// unless it was kept.
class PartialFolder {
public:
  explicit PartialFolder(std::filesystem::path path) : path_(std::move(path)) {}
  ~PartialFolder();
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Call when it is in its place.
  void keep() { kept_ = true; }

private:
  std::filesystem::path path_;
  bool kept_ = false;
};

}  // namespace plumbline
