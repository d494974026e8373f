#include "framework/WriteFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace plumbline {
namespace {

/// Closes itself; keeps errno.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool close() {
    if (fd_ < 0) return true;
    const int error = errno;
    const bool good = ::close(fd_) == 0;
    if (good) errno = error;
    fd_ = -1;
    return good;
  }

private:
  int fd_;
};

/// Some file systems cannot sync (EINVAL): what they hold is as safe as it gets.
bool sync(int fd) { return ::fsync(fd) == 0 || errno == EINVAL; }

/// What is no file, as /dev/null, must stay what it is.
bool isDeviceOrPipe(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

bool writeOnto(const std::string& path, const std::string& content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  return file.get() >= 0 && writeAll(file.get(), content) && file.close();
}

bool writePartial(const std::string& partial, const std::string& content) {
  Descriptor file(::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  return file.get() >= 0 && writeAll(file.get(), content) && sync(file.get()) && file.close();
}

/// Makes the rename outlast a loss of power.
bool syncFolderOf(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return syncToDisk(folder.empty() ? "." : folder);
}

}  // namespace

bool writeAll(int fd, std::string_view rest) {
  while (!rest.empty()) {
    const ssize_t written = ::write(fd, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool syncToDisk(const std::string& path) {
  // What cannot be opened, as a folder without the right to read it, is complete all the same.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  return file.get() < 0 || sync(file.get());
}

void writeFile(const std::string& path, const std::string& content) {
  if (isDeviceOrPipe(path)) {
    if (writeOnto(path, content)) return;
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
  }
  const std::string partial = path + ".part";
  if (!writePartial(partial, content) || std::rename(partial.c_str(), path.c_str()) != 0) {
    const int error = errno;
    std::remove(partial.c_str());
    throw std::runtime_error("cannot write " + path + ": " + std::strerror(error));
  }
  if (!syncFolderOf(path)) throw std::runtime_error("cannot write " + path + ": " + std::strerror(errno));
}

}  // namespace plumbline
