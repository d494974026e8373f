#include "framework/SingleLine.h"

#include <filesystem>
#include <new>

namespace plumbline {

std::string singleLine(std::string text) {
  constexpr std::size_t longest = 1000;
  if (text.size() > longest) {
    text.resize(longest);
    text += "...";
  }
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

std::string errorLine(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "out of memory";
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return singleLine(file->path1().string() + ": " + file->code().message());
  return singleLine(error.what());
}

}  // namespace plumbline
