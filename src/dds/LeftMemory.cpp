#include "dds/LeftMemory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

namespace plumbline::dds {
namespace {

constexpr std::string_view prefix = "fastrtps_", suffix = "_el";
constexpr std::size_t digits = 16;

/// Of a process's own memory; ports, which several share, have other names.
bool isLockOfSegment(std::string_view name) {
  if (name.size() != prefix.size() + digits + suffix.size()) return false;
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return false;
  return std::ranges::all_of(name.substr(prefix.size(), digits),
                             [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool remove(const std::string& lock, std::chrono::seconds age) {
  const int fd = open(lock.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (fd < 0) return false;
  struct stat about {};
  const bool left = fstat(fd, &about) == 0 && S_ISREG(about.st_mode) && about.st_uid == geteuid() &&
                    about.st_mtime + age.count() <= std::time(nullptr) && flock(fd, LOCK_EX | LOCK_NB) == 0;
  if (left) {
    unlink(lock.substr(0, lock.size() - suffix.size()).c_str());
    unlink(lock.c_str());
  }
  close(fd);
  return left;
}

}  // namespace

std::size_t removeLeftMemory(const std::string& folder, std::chrono::seconds age) noexcept {
  std::size_t count = 0;
  try {
    std::vector<std::string> locks;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (isLockOfSegment(entry.path().filename().string())) locks.push_back(entry.path().string());
    }
    for (const std::string& lock : locks) count += remove(lock, age) ? 1 : 0;
  } catch (const std::exception&) {  // no such folder, no memory: it stays
  }
  return count;
}

}  // namespace plumbline::dds
