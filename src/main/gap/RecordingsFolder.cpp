#include "main/gap/RecordingsFolder.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace plumbline::gap {

namespace {

namespace fs = std::filesystem;

bool isPartOfRun(const fs::path& file) {
  constexpr std::array names = {"run.json", "run.csv", "run.csv.gz", "SECRET"};
  return fs::is_regular_file(file) && std::ranges::find(names, file.filename()) != names.end();
}

/// Whatever in a folder is neither of a run nor a folder of one; empty: nothing.
std::string whatIsNoRun(const fs::path& folder, int depth = 1) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (isPartOfRun(entry.path())) continue;
    if (depth == 0 || entry.is_symlink() || !entry.is_directory()) return entry.path().string();
    if (std::string other = whatIsNoRun(entry.path(), depth - 1); !other.empty()) return other;
  }
  return "";
}

}  // namespace

RecordingsFolder::RecordingsFolder(const std::string& path, bool replace) : place_(path) {
  while (place_.size() > 1 && place_.back() == '/') place_.pop_back();
  part_ = place_ + ".part";
  std::error_code error;
  if (fs::exists(place_, error) && !(fs::is_directory(place_, error) && fs::is_empty(place_, error))) {
    if (!replace)
      throw std::invalid_argument(place_ +
                                  " is there already; --force replaces it, or name a new folder with -o");
    const std::string other = fs::is_directory(place_) ? whatIsNoRun(place_) : place_;
    if (!other.empty())
      throw std::invalid_argument(other + " is no recording; --force replaces folders of recordings alone");
  }
  fs::remove_all(part_, error);
}

RecordingsFolder::~RecordingsFolder() {
  std::error_code error;
  fs::remove_all(part_, error);
}

void RecordingsFolder::putInPlace() {
  const std::string old = place_ + ".old";
  std::error_code error, ignored;
  fs::remove_all(old, ignored);
  const bool replaced = fs::exists(place_, ignored);
  // Both change places at once where the file system can: whoever is killed there leaves one or the other.
  if (replaced && renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(part_, ignored);
    return;
  }
  if (replaced && errno != EINVAL && errno != ENOSYS)
    throw std::runtime_error(place_ + ": cannot be written: " + std::strerror(errno));
  if (replaced) fs::rename(place_, old, error);
  if (!error) fs::rename(part_, place_, error);
  if (error) {
    if (replaced && !fs::exists(place_, ignored)) fs::rename(old, place_, ignored);
    throw std::runtime_error(place_ + ": cannot be written: " + error.message());
  }
  fs::remove_all(old, ignored);
}

}  // namespace plumbline::gap
