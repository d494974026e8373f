// bin/gap effects: the library, for people.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "gap/effects/Effects.h"
#include "main/gap/Commands.h"

namespace plumbline::gap {

void addEffects(CLI::App& app) {
  CLI::App* command = app.add_subcommand("effects", "Lists the effects that a diagnosis knows");
  command->callback([] {
    for (const Effect* effect : effects()) {
      std::printf("%-22s %-11s %s\n%35sShown by: %s\n", std::string(effect->id).c_str(),
                  std::string(effect->unit).c_str(), std::string(effect->sentence).c_str(), "",
                  std::string(effect->exposedBy).c_str());
    }
  });
}

}  // namespace plumbline::gap
