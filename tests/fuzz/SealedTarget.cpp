// Benchmarks with sealed answers.
#include "fuzz/Readers.h"
#include "gap/blind/BlindCase.h"
#include "gap/record/Secret.h"

namespace plumbline::fuzz {
namespace {

void sealedCases(std::string_view bytes) {
  refusesInOneLine([&] {
    const gap::BlindSet set = gap::parseBlindSet(std::string(bytes));
    require(gap::blindSetText(gap::parseBlindSet(gap::blindSetText(set))) == gap::blindSetText(set),
            "a set changes when it is read back");
  });
  refusesInOneLine([&] { gap::unseal(std::string(bytes)); });
}

std::vector<std::string> sealedCasesSeeds() {
  gap::BlindSet set{"xl330_pendulum", "own", "hang", 3, {}};
  set.cases.push_back(
      {"c01", gap::BlindKind::single, {{"backlash", "pendulum", "", 0.03, {}}}, 12.5, "pos.pendulum", 4});
  set.cases.push_back({"c02", gap::BlindKind::none, {}, 0, "", 5});
  return {gap::blindSetText(set), gap::seal("a text", 7), gap::seal("", 1)};
}

const Registered sealedCasesTarget({"sealedCases", sealedCases, sealedCasesSeeds, 6000});

}  // namespace
}  // namespace plumbline::fuzz
