// modules.cfg: which modules an agent is made of.
#include "framework/ModulesConfig.h"
#include "fuzz/Readers.h"

namespace plumbline::fuzz {
namespace {

void modulesConfig(std::string_view bytes) {
  const std::string path = scratchFile("modules/modules.cfg", bytes);
  scratchFile("modules/other.cfg", "A\nB C\n");
  refusesInOneLine([&] {
    const ModulesConfig config = parseModulesConfig(bytes, path);
    for (const ThreadConfig& thread : config.threads) {
      require(!thread.name.empty(), "a thread without a name");
      require(thread.priority >= 0 && thread.priority <= ThreadConfig::maxPriority,
              "a priority that is none");
      require(thread.rate >= 0 && thread.rate <= ThreadConfig::maxRate, "a rate that is none");
      for (const ModulesConfigLine& line : thread.lines) require(!line.provider.empty(), "a line of nobody");
    }
  });
}

std::vector<std::string> modulesConfigSeeds() {
  std::vector<std::string> all = contentsOf("config/modules", ".cfg");
  all.push_back(contentOf("config/platforms/simspark/modules.cfg"));
  all.push_back("[first 3 50]\nA B\ninclude other.cfg\n[second 0]\nC\n");
  all.push_back("include modules.cfg\n");
  return all;
}

const Registered modulesConfigTarget({"modulesConfig", modulesConfig, modulesConfigSeeds, 8000});

}  // namespace
}  // namespace plumbline::fuzz
