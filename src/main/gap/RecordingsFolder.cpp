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

/// A name in a folder that belongs to no run; empty: none.
std::string whatIsNoRun(const fs::path& folder, int depth = 1) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (isPartOfRun(entry.path())) continue;
    if (depth == 0 || entry.is_symlink() || !entry.is_directory()) return entry.path().string();
    if (std::string other = whatIsNoRun(entry.path(), depth - 1); !other.empty()) return other;
  }
  return "";
}

/// The folder's name without a slash at its end; throws if it may not be written.
std::string placeOf(std::string place, bool replace) {
  while (place.size() > 1 && place.back() == '/') place.pop_back();
  std::error_code error;
  if (!fs::exists(place, error) || (fs::is_directory(place, error) && fs::is_empty(place, error)))
    return place;
  if (!replace)
    throw std::invalid_argument(place + " exists already; --force replaces it, or name a new folder with -o");
  const std::string other = fs::is_directory(place) ? whatIsNoRun(place) : place;
  if (!other.empty())
    throw std::invalid_argument(other + " is not a recording; --force replaces only folders of recordings");
  return place;
}

}  // namespace

RecordingsFolder::RecordingsFolder(const std::string& path, bool replace)
    : place_(placeOf(path, replace)), part_(place_ + ".part") {
  std::error_code error;
  fs::remove_all(part_.path(), error);
}

void RecordingsFolder::putInPlace() {
  const std::string old = place_ + ".old";
  std::error_code error, ignored;
  fs::remove_all(old, ignored);
  const bool replaced = fs::exists(place_, ignored);
  // Exchanges both at once, if the file system can: a killed program leaves one or the other complete.
  if (replaced && renameat2(AT_FDCWD, partial().c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0) {
    fs::remove_all(part_.path(), ignored);
    return;
  }
  if (replaced && errno != EINVAL && errno != ENOSYS)
    throw std::runtime_error(place_ + ": cannot be written: " + std::strerror(errno));
  if (replaced) fs::rename(place_, old, error);
  if (!error) fs::rename(part_.path(), place_, error);
  if (error) {
    if (replaced && !fs::exists(place_, ignored)) fs::rename(old, place_, ignored);
    throw std::runtime_error(place_ + ": cannot be written: " + error.message());
  }
  fs::remove_all(old, ignored);
}

}  // namespace plumbline::gap
