#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumbline::gap {

/// The file from which a stopped diagnosis continues: JSON, with a mark of all that its content depends on
/// (EvidenceMark.h, InferenceMark.h) and a sum of the content. Without a path there is no file.
class MemoryFile {
public:
  /// A line for the user; an empty function is not called.
  using Warn = std::function<void(const std::string&)>;

  MemoryFile(std::string path, std::string mark, Warn warn);

  /// Calls `take` with what was stored, if there is a file of this mark. A file that cannot be used is as
  /// good as none, for everything in it can be found again; warn says so. False: nothing was taken, or
  /// `take` threw a std::exception and may have taken a part.
  bool read(const std::function<void(const nlohmann::json& content)>& take) const;
  /// Replaces the file. False where it cannot be written: warn says so once, and later calls do nothing.
  bool write(const nlohmann::json& content);
  /// Removes the file: the diagnosis is done.
  void forget() const;

  const std::string& path() const { return path_; }

private:
  void warn(const std::string& text) const;

  std::string path_, mark_;
  Warn warn_;
  bool writable_ = true;
};

}  // namespace plumbline::gap
