#pragma once
#include <filesystem>

namespace plumbline {

/// A folder that is being written next to its final place. It is removed with this object, also after an
/// exception, unless it was kept.
class PartialFolder {
public:
  explicit PartialFolder(std::filesystem::path path);
  ~PartialFolder();
  PartialFolder(const PartialFolder&) = delete;
  PartialFolder& operator=(const PartialFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Call when it is in its place.
  void keep() { kept_ = true; }

  /// Removes the folders of all objects that there are: for a program that ends without their destructors.
  /// Leaves them where memory or the list of them cannot be had, as after a kill; the next run removes them.
  static void removeAll() noexcept;

private:
  void remove() const;
  std::filesystem::path path_;
  bool kept_ = false;
  PartialFolder* next_ = nullptr;  ///< in the list of all
};

}  // namespace plumbline
