// The bounded run of the fuzz targets: the known inputs and some thousands of damaged ones, the same every
// time, and what `make fuzz` kept in tests/data/fuzz. PLUMBLINE_FUZZ_SEED=2 takes others,
// PLUMBLINE_FUZZ_ROUNDS=10 ten times as many. `make fuzz` goes further.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iomanip>
#include <sstream>

#include "fuzz/Corpus.h"
#include "fuzz/Mutator.h"
#include "fuzz/Targets.h"

namespace plumbline::fuzz {
namespace {

unsigned fromEnvironment(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

std::string quoted(std::string_view bytes) {
  std::ostringstream out;
  for (const char c : bytes.substr(0, 2000)) {
    if (c >= ' ' && c <= '~' && c != '\\')
      out << c;
    else
      out << "\\x" << std::hex << std::setw(2) << std::setfill('0') << (static_cast<unsigned>(c) & 0xff);
  }
  return out.str();
}

class Mutations : public testing::TestWithParam<Target> {
protected:
  static void expectSurvived(std::string_view input) {
    try {
      GetParam().run(input);
    } catch (const std::exception& problem) {
      FAIL() << problem.what() << " at input " << quoted(input);
    }
  }
};

TEST_P(Mutations, areSurvived) {
  const auto seeds = GetParam().seeds();
  ASSERT_FALSE(seeds.empty());
  for (const std::string& input : seeds) expectSurvived(input);
  Mutator mutator(seeds, fromEnvironment("PLUMBLINE_FUZZ_SEED", 1));
#if defined(__SANITIZE_ADDRESS__)
  constexpr int share = 4;  // slower; the same inputs as the first quarter of the others'
#else
  constexpr int share = 1;
#endif
  const int rounds =
      GetParam().rounds / share * static_cast<int>(fromEnvironment("PLUMBLINE_FUZZ_ROUNDS", 1));
  for (int round = 0; round < rounds && !HasFailure(); ++round) expectSurvived(mutator.next());
  RecordProperty("inputs", rounds + static_cast<int>(seeds.size()));
}

/// What libFuzzer has learnt about the reader, and what once broke it.
TEST_P(Mutations, keptInputsAreSurvived) {
  for (const std::string& input : keptInputs("tests/data/fuzz", GetParam().name)) expectSurvived(input);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Mutations, testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Mutator, theSameSeedTheSameInputs) {
  const std::vector<std::string> seeds{"(he1 1.5)(lle4 -0.25)(beam -1 2 90)(say hello)(syn)", "(syn)"};
  Mutator first(seeds, 3), second(seeds, 3), other(seeds, 4);
  int different = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string text = first.next();
    EXPECT_EQ(text, second.next());
    if (text != other.next()) ++different;
  }
  EXPECT_GT(different, 100);
}

/// A reader that contradicts itself is noticed.
TEST(Require, throwsWhatIsBroken) {
  EXPECT_NO_THROW(require(true, "all is well"));
  EXPECT_THROW(require(false, "it is broken"), Broken);
}

}  // namespace
}  // namespace plumbline::fuzz
