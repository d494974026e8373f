// Entries of libFuzzer, used by `make fuzz`: PLUMBLINE_FUZZ_TARGET names the target. With
// PLUMBLINE_FUZZ_SEEDS it writes the known inputs, and those kept of earlier runs, to that folder and ends.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "fuzz/Corpus.h"
#include "fuzz/Readers.h"

namespace {
const plumbline::fuzz::Target* chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  plumbline::fuzz::learns = true;
  const char* name = std::getenv("PLUMBLINE_FUZZ_TARGET");
  for (const auto& target : plumbline::fuzz::targets())
    if (name && std::strcmp(name, target.name) == 0) chosen = &target;
  if (!chosen) {
    for (const auto& target : plumbline::fuzz::targets()) std::printf("%s\n", target.name);
    std::exit(name && *name ? 2 : 0);
  }
  if (const char* folder = std::getenv("PLUMBLINE_FUZZ_SEEDS")) {
    int number = 0;
    std::vector<std::string> inputs = chosen->seeds();
    for (std::string& kept : plumbline::fuzz::keptInputs("tests/data/fuzz", chosen->name))
      inputs.push_back(std::move(kept));
    for (const std::string& seed : inputs)
      std::ofstream(std::string(folder) + "/seed" + std::to_string(++number), std::ios::binary) << seed;
    std::exit(0);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
