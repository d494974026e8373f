#include "framework/ReadFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace plumbline {
namespace {

constexpr std::size_t piece = 1 << 16;  // [bytes]

}  // namespace

std::string readFile(const std::string& path, std::size_t maxBytes) {
  const auto failed = [](int error) {
    return FileProblem(std::string("cannot be read: ") + std::strerror(error));
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw failed(errno);
  // Into a string of its own: streams that collect text take a lack of memory for the end of it. Piece by
  // piece: most files are far smaller than their bound.
  std::string text;
  errno = 0;
  while (stream && text.size() <= maxBytes) {
    const std::size_t had = text.size(), wanted = std::min(piece, maxBytes + 1 - had);
    text.resize(had + wanted);
    stream.read(text.data() + had, static_cast<std::streamsize>(wanted));
    if (stream.bad()) throw failed(errno != 0 ? errno : EISDIR);
    text.resize(had + static_cast<std::size_t>(stream.gcount()));
  }
  if (text.size() > maxBytes) throw FileProblem("is larger than " + std::to_string(maxBytes >> 20) + " MB");
  return text;
}

}  // namespace plumbline
