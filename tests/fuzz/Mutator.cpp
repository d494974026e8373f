#include "fuzz/Mutator.h"

#include <array>
#include <string_view>

namespace plumbline::fuzz {

namespace {
using std::string_view_literals::operator""sv;
/// What readers of numbers, lists and lengths stumble over.
constexpr std::array words = {"1e308"sv,
                              "-1e308"sv,
                              "nan"sv,
                              "inf"sv,
                              "-0"sv,
                              "1e-320"sv,
                              "99999999999999999999"sv,
                              "0x1p9"sv,
                              "("sv,
                              ")"sv,
                              "()"sv,
                              "(((((((("sv,
                              "\0"sv,
                              "\xff\xff\xff\xff"sv,
                              "\x00\x00\x00\x05"sv,
                              "\n"sv,
                              "\n.\n"sv,
                              " "sv,
                              "\""sv,
                              "\\"sv,
                              "1000000"sv,
                              "-1"sv,
                              "2147483648"sv,
                              "\x80\x01"sv};
constexpr std::string_view letters = "() \0-.0123456789eE+nai\xff\x80\n\"{}:,tfSLTRD"sv;
constexpr std::size_t longest = 1 << 17;
}  // namespace

void Mutator::damage(std::string& text) {
  const std::size_t at = below(text.size() + 1);
  switch (below(8)) {
    case 0:
      if (at < text.size()) text[at] = letters[below(letters.size())];
      break;
    case 1:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      break;
    case 2:
      text.erase(at, 1 + below(50));
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      text.insert(at, words[below(words.size())]);
      break;
    case 5: {  // a word in the place of a number or name
      const std::size_t begin = text.find_first_of(" (", at);
      if (begin == std::string::npos) break;
      const std::size_t end = text.find_first_of(" )(", begin + 1);
      text.replace(begin + 1, end == std::string::npos ? end : end - begin - 1, words[below(words.size())]);
      break;
    }
    case 6: {  // a part of another input
      const std::string& other = seeds_[below(seeds_.size())];
      text.insert(at, other.substr(below(other.size() + 1), below(200)));
      break;
    }
    default:
      if (text.size() < longest) text.insert(at, text.substr(below(text.size() + 1), below(300)));
  }
}

std::string Mutator::next() {
  std::string text = seeds_[below(seeds_.size())];
  for (std::size_t n = below(6); n > 0; --n) damage(text);
  if (text.size() > longest) text.resize(longest);
  return text;
}

}  // namespace plumbline::fuzz
