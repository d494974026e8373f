#include "framework/ReadFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace plumbline {

std::string readFile(const std::string& path, std::size_t maxBytes) {
  const auto failed = [](int error) {
    return FileProblem(std::string("cannot be read: ") + std::strerror(error));
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw failed(errno);
  // Into a string of its own: streams that collect text take a lack of memory for the end of it.
  std::string text(maxBytes + 1, '\0');
  errno = 0;
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw failed(errno != 0 ? errno : EISDIR);
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > maxBytes) throw FileProblem("is larger than " + std::to_string(maxBytes >> 20) + " MB");
  return text;
}

}  // namespace plumbline
