#include "fuzz/Corpus.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <stdexcept>

#include "fuzz/Readers.h"

namespace plumbline::fuzz {

namespace fs = std::filesystem;

std::vector<std::string> packedInputs(const std::string& path) {
  const std::string bytes = contentOf(path);
  std::vector<std::string> inputs;
  std::size_t at = 0;
  while (at < bytes.size()) {
    const std::size_t end = bytes.find('\n', at);
    std::size_t length = 0;
    const char* first = bytes.data() + at;
    const char* last = bytes.data() + std::min(end, bytes.size());
    const auto read = std::from_chars(first, last, length);
    if (end == std::string::npos || read.ec != std::errc() || read.ptr != last ||
        length >= bytes.size() - end - 1 || bytes[end + 1 + length] != '\n')
      throw std::runtime_error(path + ": no whole input at byte " + std::to_string(at));
    inputs.push_back(bytes.substr(end + 1, length));
    at = end + length + 2;
  }
  return inputs;
}

std::vector<std::string> keptInputs(const std::string& folder, std::string_view target) {
  std::vector<std::string> inputs;
  const fs::path packed = fs::path(folder) / (std::string(target) + ".inputs");
  if (fs::exists(packed)) inputs = packedInputs(packed.string());
  const fs::path found = fs::path(folder) / "found";
  if (!fs::exists(found)) return inputs;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(found))
    if (entry.path().filename().string().starts_with(std::string(target) + "-"))
      names.push_back(entry.path().string());
  std::ranges::sort(names);
  for (const std::string& name : names) inputs.push_back(contentOf(name));
  return inputs;
}

}  // namespace plumbline::fuzz
