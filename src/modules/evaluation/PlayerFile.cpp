#include "modules/evaluation/PlayerFile.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "framework/WriteFile.h"
#include "modules/evaluation/OutputProblems.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

bool isPlayerFile(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".csv" && (name.starts_with("left-") || name.starts_with("right-"));
}

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": cannot be written: " + reason + "; choose another folder");
}

}  // namespace

PlayerFile::PlayerFile(std::string what, std::string columns)
    : what_(std::move(what)), columns_(std::move(columns)) {}

PlayerFile::~PlayerFile() { close(); }

void PlayerFile::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

void PlayerFile::prepare(const std::string& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) fail(folder, problem.message());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, std::strerror(errno));
  fs::directory_iterator entry(folder, problem);
  if (problem) return;  // it may be written and not read
  for (; !problem && entry != fs::directory_iterator(); entry.increment(problem)) {
    const std::string path = entry->path().string();
    if (!isPlayerFile(entry->path())) continue;
    std::error_code unknown;
    if (fs::is_directory(entry->path(), unknown)) fail(path, std::strerror(EISDIR));
    if (::access(path.c_str(), W_OK) != 0) fail(path, std::strerror(errno));
  }
}

/// Half a line, or no line at all, would be an error for who reads the file. A device has no size.
void PlayerFile::cutOff() {
  ended_ = true;
  [[maybe_unused]] const int ignored = fd_ < 0 ? 0 : ::ftruncate(fd_, size_);
  std::error_code unknown;
  if (fd_ >= 0 && size_ == 0 && fs::is_regular_file(path_, unknown)) fs::remove(path_, unknown);
  close();
}

void PlayerFile::append(const std::string& text) {
  if (!writeAll(fd_, text)) throw std::system_error(errno, std::generic_category());
  size_ += static_cast<std::int64_t>(text.size());
}

void PlayerFile::write(const std::string& folder, const PlayerInfo& player, const std::string& lines,
                       OutputProblems& problems) {
  if (ended_) return;
  try {
    if (fd_ < 0) {
      path_ = fmt::format("{}/{}-{}.csv", folder, player.leftSide ? "left" : "right", player.number);
      fs::create_directories(folder);
      fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
      if (fd_ < 0) throw std::system_error(errno, std::generic_category());
      append(columns_ + '\n');
    }
    append(lines);
  } catch (const std::system_error& error) {
    cutOff();
    problems.add(fmt::format("{} end here: {}: cannot be written: {}; make room, or choose another folder",
                             what_, path_, error.code().message()));
  }
}

}  // namespace plumbline
