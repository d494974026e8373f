#include <gtest/gtest.h>

#include <random>

#include "framework/BinaryStream.h"
#include "framework/StreamExamples.h"
#include "framework/TextStream.h"

namespace plumbline {
namespace {

/// Changes, inserts, removes or repeats a few bytes. Same seed, same mutations.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t count = 1 + below(4); count > 0 && !bytes.empty(); --count) {
    const std::size_t at = below(bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.insert(at, 1 + below(3), "{}[]\" -19.e\xff"[below(13)]);
        break;
      case 3:
        bytes.erase(at, 1 + below(8));
        break;
      default:
        bytes.insert(at, bytes.substr(at, below(40)));
    }
  }
  return bytes;
}

/// Whatever arrives is read, or is an error that leaves the value alone; a value that was read writes and
/// reads itself again. What could be undefined, the sanitizers tell.
template <typename Read, typename Write>
void fuzz(const std::string& start, Read read, Write write) {
  std::mt19937 random(7);
  int good = 0, bad = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string input = mutated(start, random);
    Everything value;
    if (!read(input, value).empty()) {
      bad++;
      ASSERT_EQ(toText(value), toText(Everything()));
      continue;
    }
    good++;
    Everything again;
    const std::string output = write(value);
    ASSERT_EQ(read(output, again), "");
    ASSERT_EQ(write(again), output);
  }
  // Both happen, otherwise the mutations do not test anything.
  EXPECT_GT(good, 200);
  EXPECT_GT(bad, 1500);
}

TEST(StreamFuzzTest, text) {
  fuzz(
      toText(Everything()),
      [](const std::string& input, Everything& value) { return fromText(input, value); },
      [](const Everything& value) { return toText(value); });
}

TEST(StreamFuzzTest, binary) {
  fuzz(
      toBinary(Everything()),
      [](const std::string& input, Everything& value) { return fromBinary(input, value); },
      [](const Everything& value) { return toBinary(value); });
}

}  // namespace
}  // namespace plumbline
