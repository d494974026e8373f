#include "fuzz/Readers.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace plumbline::fuzz {
namespace {

namespace fs = std::filesystem;

class Folder {
public:
  Folder() {
    std::error_code error;
    const fs::path memory = fs::is_directory("/dev/shm", error) ? "/dev/shm" : fs::temp_directory_path();
    path = memory / ("fuzz" + std::to_string(getpid()));
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path path;
};

const fs::path& folder() {
  static const Folder one;
  return one.path;
}

}  // namespace

std::array<std::string_view, 2> halves(std::string_view bytes) {
  const std::size_t at = bytes.find(separator);
  if (at == std::string_view::npos) return {bytes, ""};
  return {bytes.substr(0, at), bytes.substr(at + separator.size())};
}

std::string scratchFolder() { return folder().string(); }

std::string scratchFile(const std::string& name, std::string_view bytes) {
  const fs::path path = folder() / name;
  if (path.parent_path() != folder()) fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

std::string contentOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> contentsOf(const std::string& from, const std::string& extension) {
  std::vector<std::string> paths, contents;
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.path().extension() == extension) paths.push_back(entry.path().string());
  std::ranges::sort(paths);
  for (const std::string& path : paths) contents.push_back(contentOf(path));
  return contents;
}

bool learns = false;

void expectOneLine(const std::string& what) {
  require(!what.empty(), "an error without a word");
  require(what.find('\n') == std::string::npos, "an error of more than one line");
  require(learns || what.find("[json.exception") == std::string::npos, "an error in the words of a library");
  require(what.size() < 2000, "an error longer than a screen");
}

}  // namespace plumbline::fuzz
