#include "framework/SingleLine.h"

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

}  // namespace plumbline
