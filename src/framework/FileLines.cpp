#include "framework/FileLines.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace plumbline {

FileLines::FileLines(std::string path, std::streamoff from)
    : path_(std::move(path)), file_(path_, std::ios::binary), end_(from) {
  if (!file_) fail();
  file_.exceptions(std::ios::badbit);  // libstdc++ then throws what it caught
  file_.seekg(from);
}

bool FileLines::next(std::string& line) {
  errno = 0;
  try {
    if (!std::getline(file_, line)) return false;
  } catch (const std::ios::failure&) {
    fail();
  }
  end_ += static_cast<std::streamoff>(line.size()) + (whole() ? 1 : 0);
  return true;
}

void FileLines::fail() const {
  throw std::runtime_error(path_ + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
}

}  // namespace plumbline
